/**
 * `npm run bench -- film`: frames a minute of `npm run film` at 1920x1080, the shares of its work, two shards on two cores
 * compared with one run on one core, and the cost of layers and supersampling.
 */

import { spawnSync } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { availableParallelism, tmpdir } from 'node:os';
import { join } from 'node:path';
import { film } from '../../scripts/film/film.mjs';
import { run as start } from '../../scripts/lib/command.mjs';
import { inRoot } from '../../scripts/lib/paths.mjs';
import * as filmPage from '../../scripts/setup/filmPage.mjs';
import { spread } from './support/spread.mjs';

/**
 * @typedef {import('../../scripts/bench/table.mjs').Figure} Figure
 * @typedef {import('../../src/app/film/order.ts').DrawnFrame & { at: number }} Timed
 */

const FULL = ['--size', '1920x1080'];
/** The scenes are in full smoke. */
const LEAD = 48;
/** From here on as many puffs die as are born, so that all frames cost about the same. */
const STEADY = 240;

/** @param {import('./support/page.mjs').Choice} choice @returns {Promise<Figure[]>} */
export async function run({ quick, say }) {
  if (!filmPage.isFresh()) await filmPage.bring();
  const [rounds, frames] = quick ? [1, 6] : [3, 24];
  /** @type {Figure[]} */
  const figures = [];
  for (const preset of ['lamp', 'train']) {
    const runs = [];
    for (let round = 0; round < rounds; ++round) {
      say(`${preset}, round ${round + 1} of ${rounds}`);
      runs.push(await timedFrames(preset, frames, FULL));
    }
    figures.push(...figuresOf(preset, runs));
  }
  for (const words of [['--layers'], ['--supersample', '2']]) {
    const ratios = [];
    for (let round = 0; round < rounds; ++round) {
      say(`${words.join(' ')}, round ${round + 1} of ${rounds}`);
      const [plain, costly] = [await timedFrames('lamp', 6, FULL), await timedFrames('lamp', 6, [...FULL, ...words])];
      ratios.push(perMinute(plain) / perMinute(costly));
    }
    figures.push({ name: `film.cost ${words.join(' ')}`, unit: 'x', ...spread(ratios), note: 'time of a frame, lamp' });
  }
  return [...figures, ...(await shardFigures(rounds, frames, say))];
}

/**
 * @param {string} preset
 * @param {number} count
 * @param {string[]} words
 * @returns {Promise<Timed[]>}
 */
async function timedFrames(preset, count, words) {
  /** @type {Timed[]} */
  const drawn = [];
  await inFolder(async (folder) => {
    const shot = [`#v=1&preset=${preset}`, '--frames', `${LEAD}-${LEAD + count - 1}`, '--out', folder];
    const files = { page: inRoot(filmPage.FOLDER), wasm: inRoot('src/sim/wasm') };
    await film([...shot, ...words], files, 'bench', (frame) => drawn.push({ ...frame, at: Date.now() }));
  });
  return drawn;
}

/** Without the first frame, which waits for the simulation before it. */
function perMinute(/** @type {Timed[]} */ frames) {
  return ((frames.length - 1) * 60_000) / (frames[frames.length - 1].at - frames[0].at);
}

/** @param {string} preset @param {Timed[][]} runs @returns {Figure[]} */
function figuresOf(preset, runs) {
  // The last frame: while it is encoded, no other is drawn.
  const ends = runs.map((frames) => frames[frames.length - 1]);
  const share = (/** @type {'drawMs' | 'readMs' | 'encodeMs'} */ part) =>
    spread(ends.map((end) => end[part] / (end.drawMs + end.readMs + end.encodeMs)));
  return [
    {
      name: `film.${preset}`,
      unit: 'frames/min',
      ...spread(runs.map(perMinute)),
      note: '1920x1080, SwiftShader, all cores',
    },
    { name: `film.${preset}.draw`, unit: 'share', ...share('drawMs'), note: 'simulating and drawing' },
    { name: `film.${preset}.read`, unit: 'share', ...share('readMs'), note: 'reading back' },
    { name: `film.${preset}.encode`, unit: 'share', ...share('encodeMs'), note: 'PNG' },
  ];
}

/** @param {number} rounds @param {number} frames @param {(line: string) => void} say @returns {Promise<Figure[]>} */
async function shardFigures(rounds, frames, say) {
  if (availableParallelism() < 2 || spawnSync('taskset', ['--version']).status !== 0) return [];
  const ratios = [];
  for (let round = 0; round < rounds; ++round) {
    say(`two shards, round ${round + 1} of ${rounds}`);
    const alone = await pinned(['1/1'], 4 * frames);
    ratios.push(alone / (await pinned(['1/2', '2/2'], 4 * frames)));
  }
  return [
    { name: 'film.twoShards', unit: 'x', ...spread(ratios), note: 'a core each, compared with one run; goal 1.8' },
  ];
}

/**
 * Milliseconds until all shards are done, each on a core of its own, with the start of their browsers.
 *
 * @param {string[]} shards
 * @param {number} count of frames
 */
async function pinned(shards, count) {
  return inFolder(async (folder) => {
    const shot = ['#v=1&preset=lamp', '--frames', `${STEADY}-${STEADY + count - 1}`, '--out', folder, ...FULL];
    const began = Date.now();
    const runs = shards.map((shard, core) =>
      start('taskset', ['-c', String(core), process.execPath, inRoot('scripts/film.mjs'), ...shot, '--shard', shard]),
    );
    const timer = setInterval(pinThreads, 1000);
    try {
      for (const { status, output } of await Promise.all(runs)) if (status !== 0) throw new Error(output);
    } finally {
      clearInterval(timer);
    }
    return Date.now() - began;
  });
}

/**
 * Pins all threads of this process's descendants to the core of their first thread. SwiftShader pins its threads itself:
 * of two browsers under `taskset -c 0` and `taskset -c 1`, both would draw on core 0.
 */
function pinThreads() {
  const { stdout } = spawnSync('ps', ['-eo', 'pid=,ppid='], { encoding: 'utf8' });
  const parents = new Map(
    stdout
      .split('\n')
      .map((line) => line.trim().split(/\s+/, 2))
      .map(([pid, parent]) => [pid, parent]),
  );
  const isOwn = (/** @type {string | undefined} */ pid) =>
    pid !== undefined && (parents.get(pid) === String(process.pid) || isOwn(parents.get(pid)));
  for (const pid of [...parents.keys()].filter(isOwn)) {
    try {
      const core = coresOf(`/proc/${pid}`);
      const strays = readdirSync(`/proc/${pid}/task`).filter((task) => coresOf(`/proc/${pid}/task/${task}`) !== core);
      for (const task of strays) spawnSync('taskset', ['-c', '-p', core, task]);
    } catch {
      // The process has ended.
    }
  }
}

/** The cores that a process or thread may run on, such as `0-1`. */
function coresOf(/** @type {string} */ folder) {
  return /Cpus_allowed_list:\s*(\S+)/.exec(readFileSync(`${folder}/status`, 'utf8'))?.[1] ?? '';
}

/**
 * @template Result
 * @param {(folder: string) => Promise<Result>} work
 */
async function inFolder(work) {
  const folder = mkdtempSync(join(tmpdir(), 'cartoon-smoke-bench-'));
  try {
    return await work(folder);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
