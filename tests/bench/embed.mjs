/**
 * `npm run bench -- embed`: what a page pays for 1, 10 and 40 widgets, in a worker and without, beside the same page with
 * nothing, with tsParticles and with model-viewer: bytes, main-thread time, processor time in view and out of view, the
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

/** @typedef {import('./embed/contestants.mjs').Contestant} Contestant @typedef {import('./embed/report.mjs').Measured} Measured */

const COUNTS = { quick: [1, 10], whole: [1, 10, 40] };
/** Fewer where every one is long. @param {number} count of widgets */
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

/** A contestant in its browser, with what is found of it. @typedef {{ contestant: Contestant, visit: Visit, found: Measured }} Entry */

/**
 * All contestants side by side, each in a browser of its own, and measured in turns: whose turn it is not is out of view.
 *
 * @param {number} count @param {boolean} quick @param {(line: string) => void} say @returns {Promise<Measured[]>}
 */
async function measure(count, quick, say) {
  const entries = await Promise.all(contestants.map((contestant) => enter(contestant, count)));
  const ms = quick ? 500 : 1000;
  const rounds = roundsOf(count);
  try {
    for (let round = 0; round < rounds; round++) {
      for (const { contestant, visit, found } of entries) {
        say(`${contestant.name}, round ${round + 1} of ${rounds}`);
        // The time to the first smoke has its rounds with one widget of ours; else one load will do.
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

/** From a host of its own, so that nothing is in any cache. @param {Contestant} contestant @param {Visit} visit @param {Entry['found']} found */
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
