/** The command line of `cartoon-smoke film`. */

import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { UserError } from '../lib/userError.mjs';
import { readCamera } from './camera.mjs';

export const USAGE = `cartoon-smoke film LINK (--frames FIRST-LAST | --stinger SECONDS) --out FOLDER [options]

  LINK                   an address with a hash, or a hash: '#v=1&preset=lamp'
  --frames 0-239         first and last frame, both included
  --out FOLDER           where the files go; finished frames in it are kept
  --fps 24               frames per second, also 24000/1001 or 23.976 (24)
  --size 1920x1080       pixels of a frame (1920x1080)
  --scale N              output pixels per CSS pixel, 0.5 to 4; ink is measured in CSS pixels (the smallest integer that
                         gives at most 1080 CSS pixels of height)
  --alpha                a transparent background
  --layers               also flats, shadow, ink, marks, surfaces and depth, each in its folder
  --format png|exr       exr: linear half floats, depth in metres as 32-bit floats (png)
  --supersample 1|2      draws at twice the size and averages in linear light (1)
  --camera FILE          keyframes of the camera in JSON
  --shard 3/16           only this part of the frames; the first is 1/16
  --states FOLDER        saves states there, and starts from the nearest one
  --states-every 48      frames between two states (48)
  --stinger 0.9          instead of the smoke and of --frames, a wipe in the look of the link: it covers the picture at
                         this time, 0.4 to 10 seconds, and clears. A JSON file has the frame and the milliseconds
  --direction 90         where the smoke of a stinger goes, -360 to 360 degrees: 0 is to the right, 90 up (0)
  --matte LAYOUT         the track matte of a stinger in its video: side-by-side, stacked or separate
  --loop                 the last frames dissolve into what is before the first one, which is up to 0.75 s later
  --video FILE           also a .webm, .mp4, .apng, .webp or .mov (ProRes 4444 by ffmpeg) of the finished frames
  --gpu                  the graphics of the machine instead of SwiftShader; pictures then depend on the machine`;

export const FLIPBOOK_USAGE = `cartoon-smoke flipbook LINK --grid 8x8 --size 2048 --seconds 2 --out FOLDER [--lights LAYOUT]
                       [--scale N] [--gpu]

  --grid 8x8             columns and rows of the atlas; each cell is a frame (8x8)
  --size 2048            width of the atlas in pixels (2048)
  --seconds 2            length of the loop (2)
  --out FOLDER           where color.png, channels.png, normals.png, motion.png, lightA.png, lightB.png and
                         flipbook.json go
  --lights unity         layout of the six-way light maps: unity, unreal or none (unity)
  --scale N              pixels per CSS pixel (1)
  --gpu                  the graphics of the machine instead of SwiftShader`;

/** Limit of the pixel ratio of a picture. */
const HIGHEST_RATIO = 4;
const FULL_HEIGHT = 1080;

/** Limits of the option duration of puff.wipe(). */
const [SHORTEST_WIPE, LONGEST_WIPE] = [0.4, 10];
const MATTES = /** @type {const} */ (['side-by-side', 'stacked', 'separate']);

const VIDEOS = /** @type {const} */ (['webm', 'mp4', 'apng', 'webp', 'mov']);
/** Limits of looped clips, as in src/page/clip/clipFile.ts. */
const [FASTEST_CLIP, LONGEST_CLIP] = [60, 16_383];

/**
 * @typedef {import('../../src/demo/film/order.ts').FilmOrder} FilmOrder
 * @typedef {import('../../src/demo/film/order.ts').FlipbookOrder} FlipbookOrder
 * @typedef {object} FilmOptions
 * @property {FilmOrder} order
 * @property {number} first of all shards
 * @property {number} last of all shards, included
 * @property {number[]} frames of this shard
 * @property {string} out
 * @property {string | undefined} states
 * @property {{ file: string, matte: string, type: import('../../src/demo/film/order.ts').VideoFormat | 'mov' } | undefined} video
 * @property {{ matte: import('../../src/demo/film/order.ts').MatteLayout | undefined, report: string } | undefined} stinger
 * @property {boolean} usesGpu
 */

const OPTIONS = /** @type {const} */ ({
  frames: { type: 'string' },
  out: { type: 'string' },
  fps: { type: 'string', default: '24' },
  size: { type: 'string', default: '1920x1080' },
  scale: { type: 'string' },
  alpha: { type: 'boolean', default: false },
  layers: { type: 'boolean', default: false },
  format: { type: 'string', default: 'png' },
  supersample: { type: 'string', default: '1' },
  camera: { type: 'string' },
  shard: { type: 'string' },
  states: { type: 'string' },
  'states-every': { type: 'string', default: '48' },
  stinger: { type: 'string' },
  direction: { type: 'string' },
  matte: { type: 'string' },
  loop: { type: 'boolean', default: false },
  video: { type: 'string' },
  gpu: { type: 'boolean', default: false },
});

/**
 * @param {string[]} words after `film`
 * @returns {FilmOptions}
 * @throws {UserError} one line that names the option
 */
export function readFilmOptions(words) {
  const { values, positionals } = parse(words, OPTIONS, 'film');
  const link = onlyLink(positionals);
  const [first, last] = values.stinger === undefined ? readFrames(values.frames) : [0, 0];
  const [width, height] = readSize(values.size);
  const supersample = readNumber('--supersample', values.supersample, 1, 2);
  const format = oneOf('--format', values.format, /** @type {const} */ (['png', 'exr']));
  const fps = readFps(values.fps);
  const states = values.states;
  const stinger = readStinger(values, fps);
  const { matte } = stinger ?? {};
  const [widest, highest] = [matte === 'side-by-side' ? 2 * width : width, matte === 'stacked' ? 2 * height : height];
  const video = readVideo(values, { format, width: widest, height: highest, fps });
  if (values.loop && values.layers) throw new UserError('--loop has no layers: leave out --layers.');
  if (!values.out) throw new UserError('Name a folder for the frames: --out FOLDER.');
  return {
    order: {
      link,
      width,
      height,
      scale: readScale(values.scale, height, supersample),
      supersample,
      fps,
      hasBackground: !values.alpha && !stinger,
      layers: values.layers,
      format,
      camera: values.camera === undefined ? [] : readCamera(values.camera, fps),
      loop: values.loop ? { first, last } : undefined,
      stinger: stinger?.order,
      statesEvery: states === undefined ? 0 : readNumber('--states-every', values['states-every'], 1, 100_000),
    },
    first,
    last,
    frames: shardOf(values.shard, first, last),
    out: values.out,
    states,
    video: video && named(video, stinger?.suffix ?? ''),
    stinger: stinger && {
      matte,
      report: video ? `${stemOf(video.file)}${stinger.suffix}.json` : join(values.out, `stinger${stinger.suffix}.json`),
    },
    usesGpu: values.gpu,
  };
}

/**
 * @template {import('node:util').ParseArgsConfig['options']} Options
 * @param {string[]} words
 * @param {Options} options
 * @param {string} command
 */
function parse(words, options, command) {
  try {
    return parseArgs({ args: words, options, allowPositionals: true, strict: true });
  } catch (error) {
    const [sentence] = (error instanceof Error ? error.message : String(error)).split(/\.\s/);
    throw new UserError(`${sentence}. cartoon-smoke ${command} --help lists the options.`);
  }
}

const FLIPBOOK = /** @type {const} */ ({
  grid: { type: 'string', default: '8x8' },
  size: { type: 'string', default: '2048' },
  seconds: { type: 'string', default: '2' },
  out: { type: 'string' },
  lights: { type: 'string', default: 'unity' },
  scale: { type: 'string', default: '1' },
  gpu: { type: 'boolean', default: false },
});

/** @type {readonly (FlipbookOrder['lights'] & string)[]} */
const LIGHT_LAYOUTS = ['unity', 'unreal'];

/**
 * @param {string[]} words after `flipbook`
 * @returns {{ order: FlipbookOrder, out: string, usesGpu: boolean }}
 * @throws {UserError} one line that names the option
 */
export function readFlipbookOptions(words) {
  const { values, positionals } = parse(words, FLIPBOOK, 'flipbook');
  const [, columns, rows] = /^([1-9]\d?)x([1-9]\d?)$/.exec(values.grid) ?? [];
  if (!columns) throw new UserError(`--grid ${values.grid}: give columns and rows, such as 8x8.`);
  const size = readNumber('--size', values.size, 16, 16_384);
  if (size % Number(columns)) throw new UserError(`--size ${size}: it has to be a multiple of ${columns} columns.`);
  const seconds = Number(values.seconds);
  if (!(seconds >= 0.1 && seconds <= 60)) throw new UserError(`--seconds ${values.seconds}: it takes 0.1 to 60.`);
  if (!values.out) throw new UserError('Name a folder for the files: --out FOLDER.');
  const cell = size / Number(columns);
  const grid = { columns: Number(columns), rows: Number(rows), width: cell, height: cell };
  const scale = readScale(values.scale, cell);
  const lights = LIGHT_LAYOUTS.find((layout) => layout === values.lights);
  if (!lights && values.lights !== 'none')
    throw new UserError(`--lights ${values.lights}: it takes unity, unreal or none.`);
  return {
    order: { link: onlyLink(positionals), ...grid, scale, seconds, lights },
    out: values.out,
    usesGpu: values.gpu,
  };
}

function onlyLink(/** @type {string[]} */ positionals) {
  if (positionals.length !== 1) throw new UserError(`Give one LINK, not ${positionals.length}. Quote it in the shell.`);
  return readLink(positionals[0]);
}

/** Query and hash of an address. @throws {UserError} without a hash */
export function readLink(/** @type {string} */ text) {
  const at = text.search(/[?#]/);
  if (at < 0 || !text.includes('#')) {
    throw new UserError(`${text} is not a link: give an address with a hash, or a hash such as '#v=1&preset=lamp'.`);
  }
  return text.slice(at);
}

/** @returns {[first: number, last: number]} */
function readFrames(/** @type {string | undefined} */ text) {
  const [, from, to = from] = /^(\d{1,6})(?:-(\d{1,6}))?$/.exec(text ?? '') ?? [];
  if (from === undefined) throw new UserError(`--frames ${text ?? 'is missing'}: give the range, such as 0-239.`);
  if (Number(to) < Number(from)) throw new UserError(`--frames ${text}: the last frame is before the first.`);
  return [Number(from), Number(to)];
}

/** @returns {[width: number, height: number]} */
function readSize(/** @type {string} */ text) {
  const [, width, height] = /^(\d{1,5})x(\d{1,5})$/.exec(text) ?? [];
  if (!Number(width) || !Number(height)) throw new UserError(`--size ${text}: give pixels, such as 3840x2160.`);
  return [Number(width), Number(height)];
}

/**
 * The pixel ratio that measures ink, puffs and strokes.
 *
 * @param {string | undefined} text
 * @param {number} height in output pixels
 * @param {number} [supersample]
 */
export function readScale(text, height, supersample = 1) {
  const scale = text === undefined ? Math.max(1, Math.ceil(height / FULL_HEIGHT)) : Number(text);
  if (!(scale >= 0.5 && scale * supersample <= HIGHEST_RATIO)) {
    const what = supersample > 1 ? `${scale} with --supersample ${supersample}` : scale;
    throw new UserError(`--scale ${what}: it takes 0.5 to ${HIGHEST_RATIO / supersample}.`);
  }
  return scale;
}

function readFps(/** @type {string} */ text) {
  const [, count, seconds = '1'] = /^(\d+(?:\.\d+)?)(?:\/(\d+))?$/.exec(text) ?? [];
  const fps = Number(count) / Number(seconds);
  if (!(fps >= 1 && fps <= 240)) {
    throw new UserError(`--fps ${text}: it takes 1 to 240, such as 24, 24000/1001 or 23.976.`);
  }
  // 23.976, 29.97 and 59.94 are short for 24000/1001, 30000/1001 and 60000/1001.
  const ofBroadcasts = (1000 * Math.round(1.001 * fps)) / 1001;
  return Math.abs(fps / ofBroadcasts - 1) < 2e-4 ? ofBroadcasts : fps;
}

/**
 * @param {string} name
 * @param {string} text
 * @param {number} min
 * @param {number} max
 */
function readNumber(name, text, min, max) {
  const number = Number(text);
  if (/^\d+$/.test(text) && number >= min && number <= max) return number;
  throw new UserError(`${name} ${text}: it takes a whole number from ${min} to ${max}.`);
}

/**
 * @template {string} Choice
 * @param {string} name
 * @param {string} text
 * @param {readonly Choice[]} choices
 */
function oneOf(name, text, choices) {
  const choice = choices.find((each) => each === text);
  if (choice === undefined) throw new UserError(`${name} ${text}: it takes ${choices.join(' or ')}.`);
  return choice;
}

/**
 * @param {{ stinger?: string, direction?: string, matte?: string } & Record<string, unknown>} values
 * @param {number} fps
 */
function readStinger(values, fps) {
  const { stinger, direction = '0', matte } = values;
  if (stinger === undefined) {
    const option = ['direction', 'matte'].find((name) => values[name] !== undefined);
    if (option) throw new UserError(`--${option} is of a stinger: give its time, such as --stinger 0.9.`);
    return undefined;
  }
  const other = ['frames', 'shard', 'states', 'camera', 'layers', 'loop'].find((name) => values[name]);
  if (other) throw new UserError(`--stinger has its own frames and camera: leave out --${other}.`);
  if (values.format !== 'png') throw new UserError('--stinger is made from PNG files: leave out --format exr.');
  const seconds = Number(stinger);
  // The first frame that is not earlier.
  const cutFrame = Math.ceil(seconds * fps - 1e-6);
  if (!(seconds >= SHORTEST_WIPE && cutFrame / fps <= LONGEST_WIPE)) {
    throw new UserError(`--stinger ${stinger}: it takes ${SHORTEST_WIPE} to ${LONGEST_WIPE} seconds.`);
  }
  const degrees = Number(direction);
  if (!(Math.abs(degrees) <= 360)) throw new UserError(`--direction ${direction}: it takes -360 to 360 degrees.`);
  return {
    order: { cutFrame, direction: degrees },
    matte: matte === undefined ? undefined : oneOf('--matte', matte, MATTES),
    suffix: `-cut-${Math.round((1000 * cutFrame) / fps)}ms`,
  };
}

/** A video whose name has a suffix. */
function named(
  /** @type {{ file: string, type: (typeof VIDEOS)[number] }} */ { file, type },
  /** @type {string} */ suffix,
) {
  const stem = `${stemOf(file)}${suffix}`;
  return { file: `${stem}.${type}`, matte: `${stem}-matte.${type}`, type };
}

/** A file without its ending. */
function stemOf(/** @type {string} */ file) {
  return file.replace(/\.\w+$/, '');
}

/**
 * @param {{ video?: string, shard?: string, stinger?: string, matte?: string }} values
 * @param {{ format: 'png' | 'exr', width: number, height: number, fps: number }} order
 */
function readVideo({ video, shard, stinger, matte }, { format, width, height, fps }) {
  if (video === undefined) return undefined;
  const type = oneOf('--video', /\.(\w+)$/.exec(video)?.[1] ?? '', VIDEOS);
  if (shard !== undefined) {
    throw new UserError('--video needs all frames: run the command again without --shard when all shards are done.');
  }
  if (stinger !== undefined && type === 'mp4') {
    throw new UserError(`--video ${video} would have no alpha: choose .webm, .apng, .webp or .mov for a stinger.`);
  }
  if (matte !== undefined && matte !== 'separate' && type === 'mov') {
    throw new UserError(
      `--video ${video} has no --matte ${matte}: choose separate, whose PNG files are in matte/, or .webm.`,
    );
  }
  if (format !== 'png') throw new UserError('--video is made from PNG files: leave out --format exr.');
  if ((type === 'webm' || type === 'mp4') && (width % 2 || height % 2)) {
    throw new UserError(`--video ${video} needs even sides, not ${width}x${height}.`);
  }
  if (type === 'apng' || type === 'webp') {
    if (fps > FASTEST_CLIP) throw new UserError(`--video ${video} has at most ${FASTEST_CLIP} frames per second.`);
    const side = Math.max(width, height);
    if (side > LONGEST_CLIP)
      throw new UserError(`--video ${video} has at most ${LONGEST_CLIP} pixels per side, not ${side}.`);
  }
  return { file: video, type };
}

/**
 * The frames of a shard: contiguous, and the union of all is the range.
 *
 * @param {string | undefined} text
 * @param {number} first
 * @param {number} last
 */
function shardOf(text, first, last) {
  const [, part, count] = /^(\d+)\/(\d+)$/.exec(text ?? '1/1') ?? [];
  const [index, shards] = [Number(part), Number(count)];
  if (!(index >= 1 && index <= shards)) throw new UserError(`--shard ${text}: give part and count, such as 3/16.`);
  const length = last - first + 1;
  const [from, to] = [index - 1, index].map((shard) => first + Math.floor((shard * length) / shards));
  return Array.from({ length: to - from }, (_, frame) => from + frame);
}
