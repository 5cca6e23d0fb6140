/**
 * `npm run bench -- film`: frames a minute of `npm run film` at 1920x1080, the shares of its work, two shards on two cores
 * compared with one run on one core, and the cost of layers and supersampling.
 */

import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { availableParallelism, tmpdir } from 'node:os';
import { join } from 'node:path';
import { film } from '../../scripts/film/film.mjs';
import { run as start } from '../../scripts/lib/command.mjs';
import { inRoot } from '../../scripts/lib/paths.mjs';
import * as filmPage from '../../scripts/setup/filmPage.mjs';
import { spread } from './support/spread.mjs';

/**
 * @typedef {import('../../scripts/bench/table.mjs').Figure} Figure
 * @typedef {import('../../src/demo/film/order.ts').DrawnFrame & { at: number }} Timed
 */

const FULL = ['--size', '1920x1080'];
/** The scenes are in full smoke. */
const LEAD = 48;
/** From here on as many puffs die as are born, so that all frames cost about the same. */
const STEADY = 240;

/** @param {import('./support/page.mjs').Choice} choice @returns {Promise<Figure[]>} */
export async function run({ quick, say }) {
  if (!filmPage.isFresh()) await filmPage.bring();
  const [rounds, frames] = quick ? [1, 6] : [3, 12];
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
  const options = [['--layers'], ['--supersample', '2']];
  const ratios = options.map(() => /** @type {number[]} */ ([]));
  for (let round = 0; round < rounds; ++round) {
    say(`cost of options, round ${round + 1} of ${rounds}`);
    const plain = perMinute(await timedFrames('lamp', 4, FULL));
    for (const [at, words] of options.entries()) {
      ratios[at].push(plain / perMinute(await timedFrames('lamp', 4, [...FULL, ...words])));
    }
  }
  for (const [at, words] of options.entries()) {
    const note = 'time of a frame, lamp';
    figures.push({ name: `film.cost ${words.join(' ')}`, unit: 'x', ...spread(ratios[at]), note });
  }
  return [...figures, ...(await shardFigures(quick ? 12 : 48, say))];
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
    const files = { page: inRoot(filmPage.FOLDER), wasm: inRoot('src/simulator/wasm') };
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

/**
 * One round, because 48 frames take three minutes. The start of a browser and the simulation before the first frame are
 * in the time of each run, so fewer frames would give less.
 *
 * @param {number} count of frames
 * @param {(line: string) => void} say
 * @returns {Promise<Figure[]>}
 */
async function shardFigures(count, say) {
  if (availableParallelism() < 2 || spawnSync('taskset', ['--version']).status !== 0) return [];
  say('one run on one core');
  const alone = await pinned(['1/1'], count);
  say('two shards, a core each');
  const ratio = alone / (await pinned(['1/2', '2/2'], count));
  return [
    { name: 'film.twoShards', unit: 'x', ...spread([ratio]), note: 'a core each, compared with one run; goal 1.8' },
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
    for (const { status, output } of await Promise.all(runs)) if (status !== 0) throw new Error(output);
    return Date.now() - began;
  });
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
