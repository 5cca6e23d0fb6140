/** `npm run film`: the files of shards, of killed runs and of one run, and the pictures of other ways to the same frame. */
import { execFile, spawn, spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { setTimeout as wait } from 'node:timers/promises';
import { fileURLToPath } from 'node:url';
import { PNG } from 'pngjs';
import { FloatType } from 'three';
import { EXRLoader } from 'three/examples/jsm/loaders/EXRLoader.js';
import { decodeApng } from '../../support/files/apng.ts';
import { expect, test } from '../../support/fixtures.ts';

type Cases = typeof import('./film.cases.ts');
type Posters = typeof import('../page/element/poster.cases.ts');

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));
const SCRIPT = 'scripts/film.mjs';
const SMALL = ['--size', '160x90'];
const HASH = '#v=1&preset=lamp&simulation.maxParticles=300';

let folder: string;
test.beforeEach(() => (folder = mkdtempSync(join(tmpdir(), 'cartoon-smoke-film-'))));
// The browser of a killed run may still write.
test.afterEach(() => rmSync(folder, { recursive: true, maxRetries: 10 }));

interface Ending {
  status: number;
  errors: string;
}

function wordsOf(link: string, frames: string, out: string, ...words: string[]): string[] {
  return [link, '--frames', frames, '--out', join(folder, out), ...SMALL, ...words];
}

/** The browser of the tests: it starts with less than the one of users, which is stopped below. */
function withShell(): NodeJS.ProcessEnv {
  return { ...process.env, CHROMIUM_PATH: process.env.TEST_BROWSER };
}

function film(...given: Parameters<typeof wordsOf>): Promise<Ending> {
  return command(wordsOf(...given));
}

function command(words: readonly string[]): Promise<Ending> {
  const parameters = [SCRIPT, ...words];
  return new Promise((resolve) => {
    execFile(process.execPath, parameters, { cwd: ROOT, env: withShell() }, (error, _output, errors) =>
      resolve({ status: error ? Number(error.code) : 0, errors }),
    );
  });
}

/**
 * Starts a run and sends it a signal when a file is there. The run has a folder of its own for temporary files.
 * @returns its exit status, null if the signal ended it
 */
async function stoppedAt(
  file: string,
  signal: NodeJS.Signals,
  words: readonly string[],
  environment = process.env,
): Promise<number | null> {
  mkdirSync(join(folder, 'temporary'), { recursive: true });
  const env = { ...environment, TMPDIR: join(folder, 'temporary') };
  const child = spawn(process.execPath, [SCRIPT, ...words], { cwd: ROOT, env, stdio: 'ignore' });
  const ended = new Promise<number | null>((resolve) => child.once('close', resolve));
  while (child.exitCode === null && !existsSync(join(folder, file))) await wait(5);
  child.kill(signal);
  return ended;
}

/** Content of the files in a folder, by name, in base64. */
function filesIn(name: string): Record<string, string> {
  const path = join(folder, name);
  const entries = readdirSync(path, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile());
  const files = entries.map((entry) => join(entry.parentPath, entry.name)).sort();
  return Object.fromEntries(files.map((file) => [file.slice(path.length), readFileSync(file, 'base64')]));
}

function pixelsOf(file: Buffer): Buffer {
  return PNG.sync.read(file).data;
}

test('shards, killed runs and one run write the same files, also from the states of a take @long', async ({ load }) => {
  const link = await (
    await load<Cases>('/tests/visual/demo/film.cases.ts')
  ).evaluate((cases, hash) => cases.disturbed(hash), HASH);
  expect(await film(link, '10-25', 'one')).toMatchObject({ status: 0 });
  const states = ['--states', join(folder, 'states'), '--states-every', '4'];
  expect(await stoppedAt('stopped/frame-000010.json', 'SIGINT', wordsOf(link, '10-25', 'stopped'))).toBe(130);
  expect(Object.keys(filesIn('stopped')).filter((name) => name.endsWith('.part'))).toEqual([]);
  expect(readdirSync(join(folder, 'temporary')), 'what the browser left').toEqual([]);
  const shard = wordsOf(link, '10-25', 'shards', '--shard', '1/2', ...states);
  expect(await stoppedAt('shards/frame-000012.png', 'SIGKILL', shard, withShell())).toBeNull();
  const unfinished = Object.keys(filesIn('shards'));
  expect(unfinished).toContain('/frame-000011.json');
  expect(unfinished).not.toContain('/frame-000017.json');
  const began = Object.keys(filesIn('states'));
  for (const part of ['2/2', '1/2']) {
    expect(await film(link, '10-25', 'shards', '--shard', part, ...states)).toMatchObject({ status: 0 });
  }
  // The second shard starts from a state of the first one.
  expect(began).toContain('/state-000010.bin');
  expect(Object.keys(filesIn('states'))).toContain('/state-000050.bin');
  const [one, shards] = [filesIn('one'), filesIn('shards')];
  expect(Object.keys(one)).toHaveLength(32);
  expect(Object.keys(shards)).toEqual(Object.keys(one));
  expect(shards).toEqual(one);
  expect(new Set(Object.values(one)).size, 'no two frames are the same').toBe(32);
});

for (const [name, hash] of [
  ['lamp', HASH],
  // Its camera, light, colours and letters move.
  ['title', '#v=1&preset=title'],
] as const) {
  test(`${name}: a frame is the picture of the PNG sequence of the page @long`, async ({ load }) => {
    const link = `?t=2.5${hash}`;
    expect(await film(link, '0-1', 'png', '--scale', '2')).toMatchObject({ status: 0 });
    const [first, second] = [0, 1].map((frame) => pixelsOf(readFileSync(join(folder, `png/frame-00000${frame}.png`))));
    const cases = await load<Cases>('/tests/visual/demo/film.cases.ts');
    const sequence = await cases.evaluate((module, given) => module.sequence(given, 2.5, 80, 45, 2), hash);
    expect(sequence).toHaveLength(2);
    expect([first, second].map((frame, at) => frame.equals(pixelsOf(Buffer.from(sequence[at], 'base64'))))).toEqual([
      true,
      true,
    ]);
    expect(first.equals(second)).toBe(false);
  });
}

test('a looped film is the loop of the page, its APNG has every byte of its frames, and its WebP their alpha @long', async ({
  load,
}) => {
  const cases = await load<Cases>('/tests/visual/demo/film.cases.ts');
  const words = ['--loop', '--alpha', '--fps', '12'];
  const [apng, webp] = ['apng', 'webp'].map((type) => join(folder, `loop.${type}`));
  for (const file of [apng, webp]) {
    expect(await film(`?t=2.5${HASH}`, '3-8', 'loop', ...words, '--video', file)).toMatchObject({ status: 0 });
  }
  const frames = [3, 4, 5, 6, 7, 8].map((frame) =>
    pixelsOf(readFileSync(join(folder, `loop/frame-00000${frame}.png`))),
  );
  const decoded = decodeApng(readFileSync(apng));
  expect(decoded).toMatchObject({ width: 160, height: 90, plays: 0, delays: Array(6).fill(1 / 12) });
  expect(decoded.frames.map((frame, at) => frame.equals(frames[at]))).toEqual(Array(6).fill(true));
  const found = await cases.evaluate((module, file) => module.webpFrames(file), readFileSync(webp, 'base64'));
  expect(found.times).toEqual([0, 0.083, 0.167, 0.25, 0.333, 0.417]);
  expect(found.loops).toBe(true);
  expect(found.alpha).toEqual(frames.map((frame) => Array.from(frame.filter((_, at) => at % 4 === 3))));
  // Frame 3 is a quarter of a second later than frame 0, at which the page begins.
  const page = await cases.evaluate((module, hash) => module.loop(hash, 2.75, 160, 90), HASH);
  const ofPage = decodeApng(Buffer.from(page, 'base64')).frames;
  expect(ofPage.map((frame, at) => frame.equals(frames[at]))).toEqual(Array(6).fill(true));
  expect(new Set(frames.map((frame) => frame.toString('base64'))).size, 'no two frames are the same').toBe(6);
});

test('a stinger covers every pixel at its cut, begins and ends empty, and its matte is true to the smoke @long', async () => {
  const video = ['--video', join(folder, 'smoke.apng'), '--matte', 'stacked'];
  const shot = ['--stinger', '0.45', '--fps', '12', '--direction', '90', ...SMALL, '--out', join(folder, 'stinger')];
  expect(await command([HASH, ...shot, ...video])).toMatchObject({ status: 0 });
  // 0.45 s are between two frames.
  const report = JSON.parse(readFileSync(join(folder, 'smoke-cut-500ms.json'), 'utf8')) as Record<string, number>;
  const { frames, covered } = report as unknown as { frames: number; covered: [number, number] };
  const about = { cutMs: 500, cutFrame: 6, fps: 12, width: 160, height: 90, direction: 90, matte: 'stacked' };
  expect(report).toMatchObject({ ...about, duration: frames / 12 });
  const file = (name: string) => pixelsOf(readFileSync(join(folder, 'stinger', name)));
  const number = (frame: number) => String(frame).padStart(6, '0');
  const pictures = Array.from({ length: frames }, (_, frame) => file(`frame-${number(frame)}.png`));
  const mattes = Array.from({ length: frames }, (_, frame) => file(`matte/${number(frame)}.png`));
  const alphas = pictures.map((picture) => picture.filter((_, at) => at % 4 === 3));
  const whole = alphas.flatMap((alpha, frame) => (alpha.every((each) => each === 255) ? [frame] : []));
  expect(whole).toContain(6);
  expect([whole[0], whole.at(-1), whole.length]).toEqual([...covered, covered[1] - covered[0] + 1]);
  expect([0, frames - 1].map((frame) => alphas[frame].some((alpha) => alpha > 0))).toEqual([false, false]);
  for (const [frame, matte] of mattes.entries()) {
    const levels = matte.filter((_, at) => at % 4 === 0);
    expect(matte.filter((_, at) => at % 4 === 3).every((alpha) => alpha === 255)).toBe(true);
    const wrong = levels.findIndex((level, at) => {
      if (frame <= 6) return level !== 0;
      if (level !== 0 && level !== 255) return true;
      // White stays, and is wherever the smoke is not opaque.
      return level === 0 && (alphas[frame][at] < 255 || mattes[frame - 1][4 * at] === 255);
    });
    expect(wrong, `frame ${frame}`).toBe(-1);
  }
  expect(mattes[frames - 1].every((level) => level === 255)).toBe(true);
  const partly = mattes.some((matte) => matte.includes(0) && matte.filter((_, at) => at % 4 === 0).includes(255));
  expect(partly, 'the matte clears gradually').toBe(true);
  const joined = decodeApng(readFileSync(join(folder, 'smoke-cut-500ms.apng')));
  expect(joined).toMatchObject({ width: 160, height: 180 });
  const isJoined = joined.frames.map((frame, at) => frame.equals(Buffer.concat([pictures[at], mattes[at]])));
  expect(isJoined).toEqual(Array(frames).fill(true));
});

test('shards of a loop write the files of one run @long', async () => {
  const words = ['--loop', '--fps', '12'];
  expect(await film(HASH, '0-9', 'one', ...words)).toMatchObject({ status: 0 });
  const states = ['--states', join(folder, 'states'), '--states-every', '2'];
  for (const part of ['1/3', '3/3', '2/3']) {
    expect(await film(HASH, '0-9', 'shards', ...words, '--shard', part, ...states)).toMatchObject({ status: 0 });
  }
  expect(Object.keys(filesIn('one'))).toHaveLength(20);
  expect(filesIn('shards')).toEqual(filesIn('one'));
});

test('the loop of the cup of tea, 480 pixels wide and 2 s long, has every byte in less than 1.5 MB @long', async () => {
  const file = join(folder, 'wisp.apng');
  const words = ['--size', '480x480', '--alpha', '--loop', '--video', file];
  expect(await film('?t=3#v=1&preset=wisp', '0-47', 'wisp', ...words)).toMatchObject({ status: 0 });
  const { frames, plays } = decodeApng(readFileSync(file));
  expect([frames.length, plays]).toEqual([48, 0]);
  const isSame = frames.map((frame, at) =>
    frame.equals(pixelsOf(readFileSync(join(folder, `wisp/frame-${String(at).padStart(6, '0')}.png`)))),
  );
  expect(isSame).toEqual(Array(48).fill(true));
  expect(statSync(file).size).toBeLessThan(1_500_000);
});

test('a frame is the picture of the poster, in OpenEXR it has the light of the PNG, and depths in metres @long', async ({
  blank,
  load,
}) => {
  const link = `?t=2.5${HASH}`;
  expect(await film(link, '0', 'png', '--scale', '2')).toMatchObject({ status: 0 });
  const first = pixelsOf(readFileSync(join(folder, 'png/frame-000000.png')));
  const session = await blank.context().newCDPSession(blank);
  const metrics = { width: 640, height: 360, deviceScaleFactor: 2, mobile: false };
  await session.send('Emulation.setDeviceMetricsOverride', metrics);
  const posters = await load<Posters>('/tests/visual/page/element/poster.cases.ts');
  const order = { link: `https://example.org/${link}`, width: 80, height: 45, isTransparent: false };
  const { png } = await posters.evaluate((module, given) => module.poster(given), order);
  await session.send('Emulation.clearDeviceMetricsOverride');
  expect(first.equals(pixelsOf(Buffer.from(png, 'base64')))).toBe(true);
  expect(await film(link, '0', 'exr', '--format', 'exr', '--layers', '--scale', '2')).toMatchObject({ status: 0 });
  const exr = exrIn('exr/frame-000000.exr');
  expect(Math.max(...exr.map((value, at) => Math.abs(value - linear(first[at], at))))).toBeLessThan(0.001);
  const depth = exrIn('exr/depth/000000.exr');
  const near = depth.filter((value, at) => at % 4 === 0 && Number.isFinite(value));
  // The camera of the scene is 6.3 m from the lamp, which stands on a table 2 m wide.
  expect(near.length).toBeGreaterThan(1000);
  expect(Math.min(...near)).toBeGreaterThan(4);
  expect(Math.max(...near)).toBeLessThan(9);
  expect(new Set(near).size, 'more depths than 8 bits have').toBeGreaterThan(300);
});

/** Pixels of a file as floats, rows from the top down. */
function exrIn(name: string): Float32Array {
  const bytes = readFileSync(join(folder, name));
  const loader = new EXRLoader().setDataType(FloatType);
  const found = loader.parse(new Uint8Array(bytes).buffer);
  const { data, width, height } = found as { data: Float32Array; width: number; height: number };
  expect([width, height]).toEqual([160, 90]);
  const rows = Array.from({ length: height }, (_, y) => data.slice(4 * width * y, 4 * width * (y + 1)));
  return Float32Array.from(rows.toReversed().flatMap((row) => [...row]));
}

/** Linear light of an sRGB code; alpha stays as it is. */
function linear(code: number, at: number): number {
  const value = code / 255;
  if (at % 4 === 3) return value;
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
}

test('supersampling averages light by coverage', async ({ load }) => {
  const cases = await load<Cases>('/tests/visual/demo/film.cases.ts');
  const [white, black, clear] = [
    [255, 255, 255, 255],
    [0, 0, 0, 255],
    [255, 0, 0, 0],
  ];
  const average = (colors: number[][]) => cases.evaluate((module, given) => module.averaged(...given), colors);
  // Half the light has the sRGB code 188.
  expect(await average([white, white, black, black])).toEqual([188, 188, 188, 255]);
  expect(await average([white, clear, clear, clear])).toEqual([255, 255, 255, 64]);
  expect(await average([clear, clear, clear, clear])).toEqual([0, 0, 0, 0]);
});

test('a stage shows the same frame in whatever order frames are asked for', async ({ load }) => {
  const cases = await load<Cases>('/tests/visual/demo/film.cases.ts');
  const orders = [
    [30, 31, 40],
    [40, 30, 31],
  ];
  const pictures = [];
  for (const order of orders) {
    pictures.push(await cases.evaluate((module, [hash, asked]) => module.sought(hash, asked), [HASH, order] as const));
  }
  expect(pictures[1]).toEqual(pictures[0]);
  expect(new Set(Object.values(pictures[0])).size).toBe(3);
});

test('mistakes in a link end the run before the first frame', async () => {
  const { status, errors } = await film('#v=1&preset=fog&emission.rat=2', '0-1', 'bad');
  expect(status).toBe(1);
  expect(errors.trim().split('\n').at(-1)).toMatch(/^The link has mistakes: There is no preset .fog.;.*emission\.rat/);
  expect(Object.keys(filesIn('bad'))).toEqual([]);
});

test('a full disk ends the run with one line, and the files on it are whole @long', () => {
  const isMountable = spawnSync('unshare', ['--mount', 'true']).status === 0;
  test.skip(!isMountable, 'Only root on Linux can mount a small disk');
  const [disk, copy] = ['disk', 'copy'].map((name) => join(folder, name));
  for (const place of [disk, copy]) mkdirSync(place);
  // The mount ends with the processes in the namespace.
  const commands = 'mount -t tmpfs -o size=96k tmpfs "$1" && shift && "$@"; status=$?; cp -r disk/. copy; exit $status';
  const run = [process.execPath, join(ROOT, SCRIPT), ...wordsOf(HASH, '0-60', 'disk')];
  const parameters = ['--mount', 'sh', '-c', commands, 'sh', disk, ...run];
  const { status, stderr } = spawnSync('unshare', parameters, { cwd: folder, encoding: 'utf8', env: withShell() });
  expect(status).toBe(1);
  expect(stderr.trim().split('\n').at(-1)).toMatch(
    /^The disk is full: .*frame-0000\d\d\.(png|json) was not written\.$/,
  );
  const names = readdirSync(copy);
  expect(names.length).toBeGreaterThan(4);
  expect(names.filter((name) => !/^frame-0000\d\d\.(png|json)$/.test(name))).toEqual([]);
  for (const name of names.filter((each) => each.endsWith('.png'))) pixelsOf(readFileSync(join(copy, name)));
});
