/**
 * `npm run bench -- embed`: the cost of 1, 10 and 40 widgets, in a worker and on the main thread, compared with an
 * empty page, with tsParticles and with model-viewer: download size, main-thread time, CPU time in and out of view,
 * time to the first picture, and memory.
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
/**
 * Fewer rounds for more widgets, because each takes longer.
 * @param {number} count of widgets
 */
const roundsOf = (count) => (count === 1 ? 5 : 3);

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
 * All contestants in parallel, each in a separate browser, measured in turns. All others are scrolled out of view.
 *
 * @param {number} count
 * @param {boolean} quick
 * @param {(line: string) => void} say
 * @returns {Promise<Measured[]>}
 */
async function measure(count, quick, say) {
  const entries = await Promise.all(contestants.map((contestant) => enter(contestant, count)));
  const ms = quick ? 500 : 1000;
  const rounds = roundsOf(count);
  try {
    for (let round = 0; round < rounds; round++) {
      for (const { contestant, visit, found } of entries) {
        say(`${contestant.name}, round ${round + 1} of ${rounds}`);
        // The time to the first smoke is measured in every round with one widget; otherwise one load is enough.
        if (round === 0 || (count === 1 && contestant.event === 'ready')) await load(contestant, visit, found);
        found.seen.push(await visit.measureSeen(quick ? 20 : 40, ms));
        found.megabytes ??= await visit.megabytes();
        found.unseen.push(await visit.measureUnseen(2 * ms));
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
