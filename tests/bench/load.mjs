/**
 * `npm run bench -- load`: time from the navigation to the first smoke in the built site, served locally with an empty
 * cache, the size on the wire until then, and the scores of Lighthouse.
 */

import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { chromium } from '@playwright/test';
import { inRoot } from '../../scripts/lib/paths.mjs';
import { serveSite } from '../../scripts/site/serve.mjs';
import { CHROMIUM_FLAGS, findBrowser } from '../../scripts/setup/browser.mjs';
import * as site from '../../scripts/setup/site.mjs';
import { loadOnce } from './load/firstSmoke.mjs';
import { lighthouseFigures } from './load/lighthouse.mjs';
import { spread } from './support/spread.mjs';

/** @typedef {import('../../scripts/bench/table.mjs').Figure} Figure */

/** Without and with rigids. */
const PRESETS = ['wisp', 'lamp'];

/** @param {import('./support/page.mjs').Choice} choice @returns {Promise<Figure[]>} */
export async function run({ quick, say }) {
  if (!site.isFresh()) await site.bring(say);
  const rounds = quick ? 5 : 9;
  /** @type {Map<string, import('./load/firstSmoke.mjs').Load[]>} */
  const found = new Map(PRESETS.map((preset) => [preset, []]));
  // In turns, so that load on the machine affects all alike. The first visit of each round warms the disk cache.
  for (let round = 0; round <= rounds; round++) {
    for (const preset of PRESETS) {
      say(`${preset}, round ${round} of ${rounds}`);
      const load = await visit(preset);
      if (round > 0) found.get(preset)?.push(load);
    }
  }
  const scores = await lighthouseFigures(inRoot('dist'), pagesIn(inRoot('dist')), quick ? 1 : 3, say);
  return [...[...found].flatMap(([preset, loads]) => figures(preset, loads)), ...scores];
}

/** @param {string} folder of the built site */
function pagesIn(folder) {
  const [preset] = readdirSync(join(folder, 'gallery')).toSorted();
  const limits = { performance: 95, accessibility: 95, practices: 95, seo: 95 };
  return {
    page: { path: '', limits: { ...limits, performance: 80 } },
    gallery: { path: `gallery/${preset}`, limits },
    article: { path: 'examples/article/index.html', limits },
  };
}

/** In a separate browser: a reused one would have cached shaders and compiled modules. */
async function visit(/** @type {string} */ preset) {
  const server = await serveSite(inRoot('dist'), '/');
  const browser = await chromium.launch({ executablePath: await findBrowser(), args: CHROMIUM_FLAGS });
  try {
    return await loadOnce(browser, `${server.address}#v=1&preset=${preset}`);
  } finally {
    await browser.close();
    await server.close();
  }
}

/** @param {string} preset @param {import('./load/firstSmoke.mjs').Load[]} loads @returns {Figure[]} */
function figures(preset, loads) {
  const suffix = preset === 'lamp' ? '' : `.${preset}`;
  const note = `preset ${preset}, 800 x 450, pixel ratio 1`;
  return [
    {
      name: `load.firstSmoke${suffix}`,
      unit: 'ms',
      ...spread(loads.map((load) => load.firstSmoke)),
      note: `${note}; goal 1000 ms`,
    },
    {
      name: `load.firstSmoke${suffix}.vsWork`,
      unit: 'x',
      ...spread(loads.map((load) => load.firstSmoke / load.workMs)),
      note: 'compared with a fixed loop in the same browser',
    },
    {
      name: `load.stage${suffix}`,
      unit: 'ms',
      ...spread(loads.map((load) => load.stageAt)),
      note: 'of that until the stage is there',
    },
    { name: `load.bytes${suffix}`, value: loads[0].bytes / 1000, unit: 'kB', note: 'JavaScript and WASM, gzip' },
  ];
}
