/** Lighthouse's scores of pages of the built site, with its mobile preset. */

import lighthouse, { defaultConfig } from 'lighthouse';
import { pageFunctions } from 'lighthouse/core/lib/page-functions.js';
import puppeteer from 'puppeteer-core';
import { CHROMIUM_FLAGS, findBrowser } from '../../../scripts/setup/browser.mjs';
import { serveSite } from '../../../scripts/site/serve.mjs';
import { spread } from '../support/spread.mjs';

/** @typedef {import('../../../scripts/bench/table.mjs').Figure} Figure */
/** @typedef {import('lighthouse').Result} Result */

/**
 * @typedef {object} MeasuredPage
 * @property {string} path in the built site
 * @property {Record<keyof typeof CATEGORIES, number>} limits goals of the scores, 0 to 100
 */

/** Figures of a page by the ids of Lighthouse. */
export const CATEGORIES = {
  performance: 'performance',
  accessibility: 'accessibility',
  practices: 'best-practices',
  seo: 'seo',
};
const TIMES = { largestPaint: 'largest-contentful-paint', blocking: 'total-blocking-time' };

/**
 * @param {string} folder of the built site
 * @param {Record<string, MeasuredPage>} pages by name
 * @param {number} rounds
 * @param {(line: string) => void} say
 * @returns {Promise<Figure[]>}
 */
export async function lighthouseFigures(folder, pages, rounds, say) {
  /** @type {Map<string, Result[]>} */
  const found = new Map(Object.keys(pages).map((name) => [name, []]));
  for (let round = 1; round <= rounds; round++) {
    for (const [name, { path }] of Object.entries(pages)) {
      say(`Lighthouse, ${name}, round ${round} of ${rounds}`);
      found.get(name)?.push(await visit(folder, path));
    }
  }
  return [...found].flatMap(([name, results]) => figuresOf(name, pages[name], results));
}

/**
 * Lighthouse slows a machine down by 4, which is too much for a slow one: its figures are to be those of a mid-range phone.
 * Lighthouse calls machines with an index of 1000 desktops, those with 125 phones of 2016; see `computeBenchmarkIndex`.
 */
export const INDEX_OF_PHONE = 375;
const LARGEST_SLOWDOWN = 4;

/** In a separate browser: a reused one would have cached shaders and compiled modules. */
async function visit(/** @type {string} */ folder, /** @type {string} */ path) {
  const server = await serveSite(folder, '/');
  const browser = await puppeteer.launch({ executablePath: await findBrowser(), args: CHROMIUM_FLAGS });
  try {
    const page = await browser.newPage();
    const index = await page.evaluate(pageFunctions.computeBenchmarkIndex);
    const slowdown = Math.min(LARGEST_SLOWDOWN, Math.max(1, index / INDEX_OF_PHONE));
    const { throttling } = defaultConfig.settings ?? {};
    const flags = { logLevel: 'error', throttling: { ...throttling, cpuSlowdownMultiplier: slowdown } };
    const report = await lighthouse(server.address + path, flags, undefined, page);
    const { lhr } = /** @type {NonNullable<typeof report>} */ (report);
    if (lhr.runtimeError)
      throw new Error(`Lighthouse could not measure ${path || 'the page'}: ${lhr.runtimeError.message}`);
    return lhr;
  } finally {
    await browser.close();
    await server.close();
  }
}

/** @param {string} name @param {MeasuredPage} page @param {Result[]} results @returns {Figure[]} */
function figuresOf(name, { limits }, results) {
  const score = (/** @type {string} */ id) => results.map(({ categories }) => 100 * (categories[id].score ?? 0));
  const time = (/** @type {string} */ id) => results.map(({ audits }) => audits[id].numericValue ?? NaN);
  const index = spread(results.map(({ environment }) => environment.benchmarkIndex)).value;
  return [
    ...Object.entries(CATEGORIES).map(([key, id]) => ({
      name: `lighthouse.${name}.${key}`,
      unit: '',
      ...spread(score(id)),
      note: `goal ${limits[/** @type {keyof typeof limits} */ (key)]}`,
    })),
    ...Object.entries(TIMES).map(([key, id]) => ({
      name: `lighthouse.${name}.${key}`,
      unit: 'ms',
      ...spread(time(id)),
    })),
    {
      name: `lighthouse.${name}.index`,
      value: index,
      unit: '',
      note: `speed of the machine; a phone has ${INDEX_OF_PHONE}`,
    },
  ];
}
