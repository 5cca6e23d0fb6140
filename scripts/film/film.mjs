/** Renders a shot to files: opens the film page in a browser and keeps what it sends. */

import { createHash } from 'node:crypto';
import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { prepareFolder, writeWhole } from './files.mjs';
import { FrameFolder } from './frames.mjs';
import { readFilmOptions } from './options.mjs';
import { bytesOf, PageRun, untilStopped } from './pageRun.mjs';
import { StateFolder } from './states.mjs';
import { encodeByFfmpeg, requireFfmpeg } from './video.mjs';

/**
 * @typedef {import('./options.mjs').FilmOptions} FilmOptions
 * @typedef {import('./server.mjs').PageFiles} PageFiles
 * @typedef {import('../../src/demo/film/order.ts').DrawnFrame} DrawnFrame
 */

/**
 * `cartoon-smoke film`.
 *
 * @param {string[]} words after `film`
 * @param {PageFiles} files of the page
 * @param {string} version of the package
 * @param {(drawn: DrawnFrame) => void} [onFrame]
 * @returns {Promise<number>} the exit status
 */
export async function film(words, files, version, onFrame) {
  const options = readFilmOptions(words);
  if (options.video?.type === 'mov') requireFfmpeg();
  if (options.video) prepareFolder(dirname(options.video.file));
  const folder = new FrameFolder(options.out);
  folder.prepare(options.stinger ? undefined : options.frames);
  const states = options.states === undefined ? undefined : new StateFolder(options.states);
  states?.prepare();
  const page = new PageRun();
  const session = new Session(options, folder, states, page, `${version}+${digestOf(files)}`, onFrame);
  return untilStopped('Film', page, (say) => session.run(files, say));
}

class Session {
  #options;
  #folder;
  #states;
  #page;
  #version;
  #onFrame;
  /** @type {number[]} */
  #frames;
  #finished = 0;
  #drawn = 0;
  #beganAt = 0;
  /** @type {(line: string) => void} */
  #say = () => undefined;

  /**
   * @param {FilmOptions} options
   * @param {FrameFolder} folder
   * @param {StateFolder | undefined} states
   * @param {PageRun} page
   * @param {string} version
   * @param {((drawn: DrawnFrame) => void) | undefined} onFrame
   */
  constructor(options, folder, states, page, version, onFrame) {
    this.#options = options;
    this.#folder = folder;
    this.#states = states;
    this.#page = page;
    this.#version = version;
    this.#onFrame = onFrame;
    this.#frames = options.frames;
  }

  /**
   * @param {PageFiles} files
   * @param {(line: string) => void} say
   * @returns {Promise<string>} a summary
   */
  async run(files, say) {
    this.#say = say;
    await this.#page.run(files, this.#options.usesGpu, (request) => this.#reply(request));
    const { video, out, order, stinger } = this.#options;
    const [first, last] = stinger ? [0, this.#frames.length - 1] : [this.#options.first, this.#options.last];
    if (video?.type === 'mov') await encodeByFfmpeg(video.file, { folder: out, first, last, fps: order.fps });
    const reused = this.#frames.length - this.#drawn;
    const outcome = `${this.#drawn} frames drawn${reused > 0 ? `, ${reused} were finished before` : ''}`;
    return stinger ? `${outcome}, ${stinger.report}` : outcome;
  }

  /** @type {import('./server.mjs').Answerer} */
  async #reply({ method, path, body, headers }) {
    const [what, ...rest] = path.split('/');
    const name = rest.join('/');
    switch (`${method} ${what}`) {
      case 'GET order':
        return { body: JSON.stringify(this.#order()) };
      case 'POST begin':
        return { body: JSON.stringify(await this.#begin(await jsonOf(body))) };
      case 'PUT file':
        if (!/^(frame-|[a-z]+\/)\d{6}\.(png|exr)$/.test(name)) return undefined;
        await this.#folder.receive(name, body);
        return {};
      case 'POST finish':
        await this.#finish(await jsonOf(body));
        return {};
      case 'GET state': {
        const state = this.#states?.latest(Number(name));
        return state ? { body: state.bytes, headers: { 'x-hash': state.hash } } : {};
      }
      case 'PUT state':
        await this.#states?.save(Number(name), String(headers['x-hash']), await bytesOf(body));
        return {};
      case 'GET picture':
        return { body: { file: this.#folder.pictureOf(Number(name)) }, headers: { 'content-type': 'image/png' } };
      case 'PUT video': {
        const { video } = this.#options;
        if (!video) return undefined;
        await writeWhole(name === 'matte' ? video.matte : video.file, body);
        return {};
      }
      case 'PUT stinger':
        if (!this.#options.stinger) return undefined;
        await writeWhole(this.#options.stinger.report, body);
        return {};
      default:
        return undefined;
    }
  }

  #order() {
    const { video, first, last, stinger } = this.#options;
    const order = { ...this.#options.order, matte: stinger?.matte };
    return video && video.type !== 'mov' ? { ...order, video: { format: video.type, first, last } } : order;
  }

  /** @param {import('../../src/demo/film/order.ts').Beginning} beginning */
  async #begin(beginning) {
    const { statesEvery: _, ...shot } = this.#options.order;
    const { link, start, renderer, last } = beginning;
    if (last !== undefined) this.#frames = Array.from({ length: last + 1 }, (_frame, at) => at);
    const frames = this.#frames;
    this.#folder.enter({ ...shot, link, start, version: this.#version, browser: this.#page.browser, renderer });
    this.#states?.enter({ link, version: this.#version });
    const missing = [];
    for (const frame of frames) if (!(await this.#folder.isFinished(frame))) missing.push(frame);
    this.#finished = frames.length - missing.length;
    this.#beganAt = Date.now();
    this.#say(`${this.#finished} of ${frames.length} frames are finished`);
    return missing;
  }

  async #finish(/** @type {DrawnFrame} */ drawn) {
    await this.#folder.finish(drawn);
    this.#onFrame?.(drawn);
    const { length } = this.#frames;
    this.#drawn++;
    this.#finished++;
    const minutes = (Date.now() - this.#beganAt) / 60_000;
    const left = ((length - this.#finished) * minutes) / this.#drawn;
    this.#say(
      `frame ${drawn.frame}, ${this.#finished} of ${length} are finished, ` +
        `${(this.#drawn / minutes).toFixed(1)} a minute, ${durationOf(left)} left`,
    );
  }
}

/** Identifies the build, so that frames and states of two builds are not mixed. */
function digestOf(/** @type {PageFiles} */ { page, wasm }) {
  const hash = createHash('sha256');
  for (const folder of [page, wasm]) {
    const files = readdirSync(folder, { recursive: true, encoding: 'utf8' }).filter((name) =>
      /\.(js|wasm)$/.test(name),
    );
    for (const name of files.sort()) hash.update(readFileSync(join(folder, name)));
  }
  return hash.digest('hex').slice(0, 12);
}

function durationOf(/** @type {number} */ minutes) {
  if (minutes < 1) return `${Math.round(60 * minutes)} s`;
  return minutes < 90 ? `${Math.round(minutes)} min` : `${(minutes / 60).toFixed(1)} h`;
}

/** @param {AsyncIterable<Uint8Array>} body */
async function jsonOf(body) {
  return JSON.parse((await bytesOf(body)).toString('utf8'));
}
