/**
 * `npm run bench -- embed`: the cost of a widget, in a worker and on the main thread, compared with an empty page, with
 * tsParticles and with model-viewer: download size, main-thread time, CPU time in and out of view, time to the first
 * picture, and memory. Then of 10 and 40 widgets in a worker, compared with an empty page and with model-viewer.
 */

import { writeFileSync } from 'node:fs';
import { inRoot } from '../../scripts/lib/paths.mjs';
import * as packaged from '../../scripts/setup/package.mjs';
import { serveSite } from '../../scripts/site/serve.mjs';
import { ball } from './embed/ball.mjs';
import { contestants, pageOf } from './embed/contestants.mjs';
import { bringPeers, PEERS } from './embed/peers.mjs';
import { report } from './embed/report.mjs';
import { Visit } from './embed/visit.mjs';

/**
 * @typedef {import('./embed/contestants.mjs').Contestant} Contestant
 * @typedef {import('./embed/report.mjs').Measured} Measured
 */

const COUNTS = { quick: [1, 10], whole: [1, 10, 40] };
const ROUNDS = 5;

/** @param {import('./support/page.mjs').Choice} choice */
export async function run({ quick, say }) {
  if (!packaged.isFresh()) await packaged.bring(say);
  await bringPeers(say);
  writeFileSync(inRoot(`${PEERS}/ball.glb`), ball());
  /** @type {Measured[]} */
  const all = [];
  for (const count of quick ? COUNTS.quick : COUNTS.whole)
    all.push(...(await measure(count, quick, (line) => say(`${count} widgets, ${line}`))));
  return report(all);
}

/**
 * A contestant, its browser and its results.
 * @typedef {{ contestant: Contestant, visit: Visit, found: Measured }} Entry
 */

/**
 * The contestants in parallel, each in a separate browser, measured in turns. All others are scrolled out of view.
 *
 * @param {number} count
 * @param {boolean} quick
 * @param {(line: string) => void} say
 * @returns {Promise<Measured[]>}
 */
async function measure(count, quick, say) {
  const taking = contestants.filter(({ isSingle }) => count === 1 || !isSingle);
  const entries = await Promise.all(taking.map((contestant) => enter(contestant, count)));
  const ms = quick ? 500 : 1000;
  try {
    for (let round = 0; round < ROUNDS; round++) {
      for (const { contestant, visit, found } of entries) {
        say(`${contestant.name}, round ${round + 1} of ${ROUNDS}`);
        // The time to the first smoke is measured in every round with one widget; otherwise one load is enough.
        if (round === 0 || (count === 1 && contestant.event === 'ready')) await load(contestant, visit, found);
        found.seen.push(await visit.measureSeen(quick ? 20 : 40, ms));
        found.megabytes ??= await visit.megabytes();
        found.unseen.push(await visit.measureUnseen(ms));
      }
    }
  } finally {
    for (const { visit } of entries) await visit.end();
  }
  const [{ found: empty }] = entries;
  return entries.map(({ found }) => ({ ...found, megabytes: difference(found.megabytes, empty.megabytes) }));
}

/** @param {Contestant} contestant @param {number} count @returns {Promise<Entry>} */
async function enter(contestant, count) {
  writeFileSync(inRoot(`${PEERS}/${contestant.name}.html`), pageOf(contestant, count));
  /** @type {Entry['found']} */
  const found = { name: contestant.name, count, files: [], loads: [], seen: [], unseen: [], megabytes: undefined };
  return { contestant, visit: await Visit.begin(), found };
}

/**
 * From a separate origin, so that nothing is cached.
 * @param {Contestant} contestant
 * @param {Visit} visit
 * @param {Entry['found']} found
 */
async function load(contestant, visit, found) {
  const server = await serveSite(inRoot('.'), '/');
  try {
    found.loads.push(
      await visit.load(`${server.address}${PEERS}/${contestant.name}.html`, contestant.event, found.count),
    );
    const fetched = server.sent.filter(({ file }) => /\.(js|wasm)$/.test(file));
    found.files = [...new Map(fetched.map((each) => [each.file, each])).values()];
  } finally {
    await server.close();
  }
}

/** @param {number | undefined} one @param {number | undefined} other */
function difference(one, other) {
  return one === undefined || other === undefined ? undefined : one - other;
}
