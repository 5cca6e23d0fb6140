/** The command line of `npm run film`, its folders, and the parts of its page that need no browser. */
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { cameraAt } from '../../../src/demo/film/film.ts';
import { nameOf, type Keyframe } from '../../../src/demo/film/order.ts';
import { requireWipeOptions } from '../../../src/page/puff/options.ts';
import { decode } from '../../../src/parameters/codec.ts';

// @ts-expect-error -- a script without declarations
import * as options from '../../../scripts/film/options.mjs';

// @ts-expect-error -- a script without declarations
import * as files from '../../../scripts/film/files.mjs';

// @ts-expect-error -- a script without declarations
import * as frames from '../../../scripts/film/frames.mjs';

// @ts-expect-error -- a script without declarations
import * as browser from '../../../scripts/film/browser.mjs';

// @ts-expect-error -- a script without declarations
import * as states from '../../../scripts/film/states.mjs';

const LINK = 'https://example.org/?t=2#v=1&preset=lamp';
const SHOT = {
  link: '#v=1&preset=lamp',
  start: 0,
  version: '1',
  browser: 'Chrome/1',
  renderer: 'SwiftShader',
  width: 4,
  height: 4,
  scale: 1,
  supersample: 1,
  fps: 24,
  hasBackground: true,
  layers: false,
  format: 'png',
  camera: [],
};

interface Read {
  order: {
    link: string;
    scale: number;
    fps: number;
    camera: { seconds: number }[];
    statesEvery: number;
    stinger?: object;
  };
  stinger?: object;
  video?: object;
  frames: number[];
}

const read = options.readFilmOptions as (words: string[]) => Read;
const given = (...words: string[]) => read([LINK, '--frames', '0-9', '--out', 'out', ...words]);

let folder: string;
beforeEach(() => (folder = mkdtempSync(join(tmpdir(), 'cartoon-smoke-film-'))));
afterEach(() => rmSync(folder, { recursive: true }));

describe('options', () => {
  it('reads the query and the hash of an address', () => {
    expect(given().order.link).toBe('?t=2#v=1&preset=lamp');
    expect(read(['#v=1', '--frames', '3', '--out', 'out'])).toMatchObject({ order: { link: '#v=1' }, frames: [3] });
  });

  it.each(['', 'https://example.org/', 'https://example.org/?t=2'])(
    'a second # ends the link after %j',
    async (page) => {
      const { order } = read([`${page}#v=1&preset=wisp#?secret=abc123`, '--frames', '0-9', '--out', 'out']);
      const { hash, search } = new URL(order.link, page || 'https://example.org/');
      expect(await decode(hash)).toEqual(await decode('#v=1&preset=wisp'));
      expect(search).toBe(page.includes('?') ? '?t=2' : '');
    },
  );

  it.each([
    ['640x360', 1],
    ['1920x1080', 1],
    ['1920x1081', 2],
    ['3840x2160', 2],
    ['7680x4320', 4],
  ])('%s has the scale %i by default', (size, scale) => {
    expect(given('--size', size).order.scale).toBe(scale);
  });

  it.each([
    ['24', 24],
    ['12.5', 12.5],
    ['25/2', 12.5],
    ['24000/1001', 24_000 / 1001],
    ['23.976', 24_000 / 1001],
    ['23.98', 24_000 / 1001],
    ['29.97', 30_000 / 1001],
    ['59.94', 60_000 / 1001],
  ])('--fps %s is %d frames per second', (text, fps) => {
    expect(given('--fps', text).order.fps).toBe(fps);
  });

  it.each([1, 2, 3, 10, 16])('the frames of %i shards are contiguous and all frames', (count) => {
    const shards = Array.from({ length: count }, (_, at) => given('--shard', `${at + 1}/${count}`).frames);
    expect(shards.flat()).toEqual([0, 1, 2, 3, 4, 5, 6, 7, 8, 9]);
  });

  it.each([
    [['--bogus'], /^Unknown option '--bogus'/],
    [['--frames', '5-1'], /^--frames 5-1: the last frame is before the first/],
    [['--frames', 'all'], /^--frames all: give the range/],
    [['--size', '4K'], /^--size 4K: give pixels/],
    [['--size', '0x9'], /^--size 0x9: give pixels/],
    [['--scale', '5'], /^--scale 5: it takes 0.5 to 4/],
    [['--scale', '4', '--supersample', '2'], /^--scale 4 with --supersample 2: it takes 0.5 to 2/],
    [['--fps', '0'], /^--fps 0: it takes 1 to 240, such as 24, 24000\/1001 or 23.976/],
    [['--fps', '24/0'], /^--fps 24\/0: it takes 1 to 240/],
    [['--fps', 'film'], /^--fps film: it takes 1 to 240/],
    [['--format', 'jpg'], /^--format jpg: it takes png or exr/],
    [['--shard', '4/3'], /^--shard 4\/3: give part and count/],
    [['--shard', '0/3'], /^--shard 0\/3: give part and count/],
    [['--video', 'out.avi'], /^--video avi: it takes webm or mp4 or apng or webp or mov/],
    [['--video', 'out.mov', '--shard', '1/2'], /^--video needs all frames/],
    [['--video', 'out.mp4', '--size', '9x9'], /^--video out.mp4 needs even sides/],
    [['--video', 'out.mp4', '--format', 'exr'], /^--video is made from PNG files/],
    [['--video', 'out.apng', '--format', 'exr'], /^--video is made from PNG files/],
    [['--video', 'out.apng', '--fps', '120'], /^--video out.apng has at most 60 frames per second/],
    [['--video', 'out.webp', '--size', '16384x9'], /^--video out.webp has at most 16383 pixels per side, not 16384/],
    [['--loop', '--layers'], /^--loop has no layers/],
    [['--direction', '90'], /^--direction is of a stinger/],
    [['--matte', 'stacked'], /^--matte is of a stinger/],
    [['--stinger', '0.9'], /^--stinger has its own frames and camera: leave out --frames/],
    [['more'], /^Give one LINK, not 2/],
    [['--camera', '/nowhere.json'], /^--camera \/nowhere.json cannot be read/],
  ])('%j is rejected in one line', (words, message) => {
    expect(() => given(...words)).toThrow(message);
    expect(() => given(...words)).not.toThrow(/\n/);
  });

  const wiped = (...words: string[]) => read([LINK, '--out', 'out', '--stinger', ...words]);

  it.each([
    [['0.9', '--fps', '60'], 54, 'out/stinger-cut-900ms.json'],
    [['0.9'], 22, 'out/stinger-cut-917ms.json'],
    [['1', '--fps', '24000/1001'], 24, 'out/stinger-cut-1001ms.json'],
    [['10', '--fps', '30'], 300, 'out/stinger-cut-10000ms.json'],
  ])('the cut of --stinger %j is frame %i, and %s says so', (words, cutFrame, report) => {
    const { order, stinger } = wiped(...words);
    expect(order).toMatchObject({ stinger: { cutFrame, direction: 0 }, hasBackground: false });
    expect(stinger).toEqual({ report: join(report), matte: undefined });
  });

  it('names the video of a stinger and its matte by the cut', () => {
    const words = ['--fps', '30', '--direction=-90', '--matte', 'separate', '--video', 'clips/smoke.webm'];
    const { order, stinger, video } = wiped('0.5', ...words);
    expect(order.stinger).toEqual({ cutFrame: 15, direction: -90 });
    expect(stinger).toEqual({ report: 'clips/smoke-cut-500ms.json', matte: 'separate' });
    expect(video).toEqual({
      file: 'clips/smoke-cut-500ms.webm',
      matte: 'clips/smoke-cut-500ms-matte.webm',
      type: 'webm',
    });
  });

  it.each([
    [['0.3'], /^--stinger 0.3: it takes 0.4 to 10 seconds/],
    [['soon'], /^--stinger soon: it takes 0.4 to 10 seconds/],
    [['9.99', '--fps', '24000/1001', '--frames', '0-9'], /leave out --frames/],
    [['1', '--loop'], /leave out --loop/],
    [['1', '--camera', 'path.json'], /leave out --camera/],
    [['1', '--format', 'exr'], /^--stinger is made from PNG files/],
    [['1', '--direction', 'left'], /^--direction left: it takes -360 to 360 degrees/],
    [['1', '--matte', 'below'], /^--matte below: it takes side-by-side or stacked or separate/],
    [['1', '--video', 'a.mp4'], /^--video a.mp4 would have no alpha/],
    [['1', '--video', 'a.mov', '--matte', 'stacked'], /^--video a.mov has no --matte stacked/],
    [['1', '--video', 'a.webp', '--matte', 'stacked', '--size', '9x8200'], /not 16400/],
  ])('a stinger with %j is rejected in one line', (words, message) => {
    expect(() => wiped(...words)).toThrow(message);
    expect(() => wiped(...words)).not.toThrow(/\n/);
  });

  it.each([0.39, 0.4, 10, 10.01])('a stinger of %d s is accepted as a wipe of the page is', (duration) => {
    const isAccepted = (call: () => unknown) => {
      try {
        return call() !== null;
      } catch {
        return false;
      }
    };
    const wipe = isAccepted(() => requireWipeOptions({ to: () => undefined, duration }));
    expect(isAccepted(() => wiped(String(duration), '--fps', '100'))).toBe(wipe);
    expect(wipe).toBe(duration === 0.4 || duration === 10);
  });

  it('rejects a link without a hash, and needs frames and a folder', () => {
    expect(() => read(['lamp', '--frames', '0', '--out', 'out'])).toThrow(/^lamp is not a link/);
    expect(() => read([LINK, '--out', 'out'])).toThrow(/^--frames is missing/);
    expect(() => read([LINK, '--frames', '0'])).toThrow(/^Name a folder/);
  });

  it.each([
    ['{}', /has to be a list/],
    ['[{"frame":0,"azimuth":1}]', /keyframe 1 has azimuth/],
    ['[{"frame":0,"camera.azimuth":"1"}]', /camera.azimuth is not a number/],
    ['[{"camera.azimuth":1}]', /keyframe 1 needs a frame/],
    ['[{"frame":2},{"frame":2}]', /keyframe 2 is not after/],
  ])('rejects the camera %s', (text, message) => {
    const file = join(folder, 'camera.json');
    writeFileSync(file, text);
    expect(() => given('--camera', file)).toThrow(message);
  });

  it('converts the frames of a camera to seconds', () => {
    const file = join(folder, 'camera.json');
    writeFileSync(file, '[{"frame":0,"camera.azimuth":1},{"frame":12,"camera.azimuth":2}]');
    expect(given('--camera', file).order.camera.map(({ seconds }) => seconds)).toEqual([0, 0.5]);
  });
});

describe('options of a flipbook', () => {
  const flipbook = options.readFlipbookOptions as (words: string[]) => { order: object };
  const flip = (...words: string[]) => flipbook([LINK, '--out', 'out', ...words]);

  it('divides the width of the atlas by its columns', () => {
    const order = { columns: 4, rows: 2, width: 256, height: 256, scale: 1, seconds: 1.5 };
    expect(flip('--grid', '4x2', '--size', '1024', '--seconds', '1.5').order).toMatchObject(order);
  });

  it.each([
    [[], 'unity'],
    [['--lights', 'unreal'], 'unreal'],
    [['--lights', 'none'], undefined],
  ])('%j gives light maps for %s', (words, lights) => {
    expect(flip(...words).order).toMatchObject({ lights });
  });

  it.each([
    [['--lights', 'godot'], /^--lights godot: it takes unity, unreal or none/],
    [['--grid', '0x2'], /^--grid 0x2: give columns and rows/],
    [['--grid', '3x3', '--size', '1024'], /^--size 1024: it has to be a multiple of 3 columns/],
    [['--seconds', 'long'], /^--seconds long: it takes 0.1 to 60/],
    [['--frames', '1-2'], /^Unknown option '--frames'/],
  ])('%j is rejected in one line', (words, message) => {
    expect(() => flip(...words)).toThrow(message);
  });
});

describe('prepareFolder', () => {
  const prepareFolder = files.prepareFolder as (folder: string) => void;
  let place: string;

  beforeEach(() => (place = mkdtempSync(join(tmpdir(), 'folder-'))));
  afterEach(() => rmSync(place, { recursive: true }));

  it('creates folders in folders and leaves nothing in them', () => {
    const inner = join(place, 'a/b/c');
    prepareFolder(inner);
    prepareFolder(inner);
    expect(readdirSync(inner)).toEqual([]);
  });

  it('rejects a file and a folder in a file', () => {
    writeFileSync(join(place, 'file'), '');
    for (const path of ['file', 'file/a/b']) {
      expect(() => prepareFolder(join(place, path))).toThrow(`${join(place, path)} cannot be written: `);
    }
  });

  it.runIf(process.platform === 'linux')('rejects a folder in /proc', () => {
    expect(() => prepareFolder('/proc/frames/of')).toThrow(/^\/proc\/frames\/of cannot be written: ENOENT/);
  });
});

describe('cameraAt', () => {
  const path: Keyframe[] = [
    { seconds: 1, values: { 'camera.azimuth': 170, 'camera.distance': 2 } },
    { seconds: 2, values: { 'camera.elevation': 30 } },
    { seconds: 3, values: { 'camera.azimuth': -170, 'camera.distance': 4 } },
  ];

  it('is linear between keyframes that have a key, and goes the shorter way around', () => {
    expect(cameraAt(path, 2)).toEqual({ 'camera.azimuth': -180, 'camera.distance': 3, 'camera.elevation': 30 });
    expect(cameraAt(path, 2.5)['camera.azimuth']).toBe(-175);
  });

  it('is constant outside the keyframes, and empty without any', () => {
    expect(cameraAt(path, 0)).toEqual({ 'camera.azimuth': 170, 'camera.distance': 2, 'camera.elevation': 30 });
    expect(cameraAt(path, 9)).toEqual({ 'camera.azimuth': -170, 'camera.distance': 4, 'camera.elevation': 30 });
    expect(cameraAt([], 9)).toEqual({});
  });
});

it('names files so that all shards use the same names', () => {
  expect(nameOf(7, undefined, 'png')).toBe('frame-000007.png');
  expect(nameOf(12345, 'ink', 'exr')).toBe('ink/012345.exr');
});

interface Folder {
  prepare(own: number[]): void;
  enter(shot: object): void;
  isFinished(frame: number): Promise<boolean>;
  receive(name: string, content: AsyncIterable<Uint8Array>): Promise<void>;
  finish(drawn: object): Promise<void>;
}

async function* chunks(...texts: string[]) {
  for (const text of texts) yield Buffer.from(text);
}

async function opened(shot: object = SHOT): Promise<Folder> {
  const opening = new (frames.FrameFolder as new (path: string) => Folder)(folder);
  opening.prepare([0, 1]);
  opening.enter(shot);
  return opening;
}

async function write(frame: number): Promise<void> {
  const one = await opened();
  await one.receive(`frame-00000${frame}.png`, chunks('pic', 'ture'));
  await one.receive(`ink/00000${frame}.png`, chunks('ink'));
  await one.finish({ frame, step: 5, hash: 'abc' });
}

describe('the folder of a shot', () => {
  it('knows finished frames by the content of all their files', async () => {
    await write(1);
    expect(await (await opened()).isFinished(0)).toBe(false);
    expect(await (await opened()).isFinished(1)).toBe(true);
    writeFileSync(join(folder, 'ink/000001.png'), 'in');
    expect(await (await opened()).isFinished(1)).toBe(false);
    await write(1);
    writeFileSync(join(folder, 'frame-000001.json'), '{');
    expect(await (await opened()).isFinished(1)).toBe(false);
  });

  it('leaves no part of a file that did not arrive, and the finished file as it was', async () => {
    await write(1);
    const one = await opened();
    const broken = async function* () {
      yield Buffer.from('pic');
      throw new Error('The connection ended.');
    };
    await expect(one.receive('frame-000001.png', broken())).rejects.toThrow('The connection ended.');
    expect(readdirSync(folder).sort()).toEqual(['frame-000001.json', 'frame-000001.png', 'ink']);
    expect(readFileSync(join(folder, 'frame-000001.png'), 'utf8')).toBe('picture');
  });

  it('removes what a killed run left of its own frames only', async () => {
    mkdirSync(join(folder, 'ink'));
    const parts = [
      '.frame-000001.png.0123abcd.part',
      '.frame-000002.png.0123abcd.part',
      'ink/.000000.png.0123abcd.part',
    ];
    for (const part of parts) writeFileSync(join(folder, part), 'pic');
    await opened();
    expect(readdirSync(folder)).toEqual(['.frame-000002.png.0123abcd.part', 'ink']);
    expect(readdirSync(join(folder, 'ink'))).toEqual([]);
  });

  it.each([
    [{ browser: 'Chrome/2' }, /the browser is "Chrome\/1", here it is "Chrome\/2"/],
    [{ renderer: 'Mesa' }, /the renderer is "SwiftShader", here it is "Mesa"/],
    [{ version: '2' }, /the version is "1", here it is "2"/],
    [{ link: '#v=1&preset=wisp' }, /the link is "#v=1&preset=lamp", here/],
    [{ fps: 25 }, /--fps is 24, here it is 25/],
  ])('rejects frames that are not %j, and names both', async (other, message) => {
    await write(1);
    await expect(opened({ ...SHOT, ...other })).rejects.toThrow(message);
  });

  it('has one sentence for a folder that cannot be written', async () => {
    const file = join(folder, 'file');
    writeFileSync(file, '');
    folder = join(file, 'under');
    await expect(opened()).rejects.toThrow(/under cannot be written: ENOTDIR: not a directory\.$/);
    folder = join(file, '..');
  });
});

describe('saved states', () => {
  interface States {
    prepare(): void;
    enter(shot: object): void;
    latest(step: number): { hash: string; bytes: Uint8Array } | undefined;
    save(step: number, hash: string, state: Uint8Array): Promise<void>;
  }
  const open = async (shot: object = SHOT) => {
    const one = new (states.StateFolder as new (path: string) => States)(folder);
    one.prepare();
    one.enter(shot);
    return one;
  };

  it('are found by the latest step, and the first one that is saved stays', async () => {
    const one = await open();
    await one.save(20, 'b', Uint8Array.of(10, 2));
    await one.save(100, 'c', Uint8Array.of(3));
    await one.save(20, 'other', Uint8Array.of(4));
    expect(one.latest(19)).toBeUndefined();
    expect(one.latest(99)).toEqual({ hash: 'b', bytes: Buffer.from([10, 2]) });
    expect(one.latest(100)?.hash).toBe('c');
  });

  it.each([
    [{ link: '#v=1&preset=wisp' }, /is of the link #v=1&preset=lamp, not of #v=1&preset=wisp/],
    [{ version: '2' }, /is of the version 1, not of 2/],
  ])('are rejected with %j', async (other, message) => {
    await (await open()).save(20, 'b', Uint8Array.of(1));
    await expect(open({ ...SHOT, ...other })).rejects.toThrow(message);
  });
});

describe('the browser', () => {
  const find = browser.findChromium as () => string;
  const program = (path: string) => {
    mkdirSync(join(path, '..'), { recursive: true });
    writeFileSync(path, '#!/bin/sh\necho Chromium 1\n', { mode: 0o755 });
    return path;
  };
  beforeEach(() => {
    for (const name of ['PATH', 'HOME', 'LOCALAPPDATA']) vi.stubEnv(name, folder);
    for (const name of ['CHROMIUM_PATH', 'PLAYWRIGHT_BROWSERS_PATH']) vi.stubEnv(name, undefined);
  });
  afterEach(() => vi.unstubAllEnvs());

  it('is one of the system, or the newest of Playwright', () => {
    const ofSystem = program(join(folder, 'google-chrome'));
    expect(find()).toBe(ofSystem);
    program(join(folder, '.cache/ms-playwright/chromium-999/chrome-linux/chrome'));
    const newest = program(join(folder, '.cache/ms-playwright/chromium-1100/chrome-linux/chrome'));
    expect(find()).toBe(newest);
  });

  it('is missing with a sentence that says what to install', () => {
    expect(find).toThrow(/^No browser was found: install Chromium or Chrome, run npx playwright install chromium, or/);
    vi.stubEnv('CHROMIUM_PATH', '/nowhere');
    expect(find).toThrow(/^CHROMIUM_PATH is \/nowhere, which does not start as a browser/);
  });
});
