/** Lighthouse's scores of pages of the built site, with its mobile preset. */

import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import lighthouse from 'lighthouse';
import puppeteer from 'puppeteer-core';
import { CHROMIUM_FLAGS, findBrowser } from '../../../scripts/setup/browser.mjs';
import { serveSite } from '../../../scripts/site/serve.mjs';
import { spread } from '../support/spread.mjs';

/** @typedef {import('../../../scripts/bench/table.mjs').Figure} Figure */
/** @typedef {import('lighthouse').Result} Result */

/** Figures of a page by the ids of Lighthouse. */
const CATEGORIES = {
  performance: 'performance',
  accessibility: 'accessibility',
  practices: 'best-practices',
  seo: 'seo',
};
const TIMES = { largestPaint: 'largest-contentful-paint', blocking: 'total-blocking-time' };

/** @param {string} folder of the built site @returns {Record<string, string>} paths by name */
function pagesOf(folder) {
  const [preset] = readdirSync(join(folder, 'gallery')).toSorted();
  return { page: '', gallery: `gallery/${preset}`, article: 'examples/article/index.html' };
}

/**
 * @param {string} folder of the built site
 * @param {number} rounds
 * @param {(line: string) => void} say
 * @returns {Promise<Figure[]>}
 */
export async function lighthouseFigures(folder, rounds, say) {
  const pages = pagesOf(folder);
  /** @type {Map<string, Result[]>} */
  const found = new Map(Object.keys(pages).map((name) => [name, []]));
  for (let round = 1; round <= rounds; round++) {
    for (const [name, path] of Object.entries(pages)) {
      say(`Lighthouse, ${name}, round ${round} of ${rounds}`);
      found.get(name)?.push(await visit(folder, path));
    }
  }
  return [...found].flatMap(([name, results]) => figuresOf(name, results));
}

/** In a separate browser: a reused one would have cached shaders and compiled modules. */
async function visit(/** @type {string} */ folder, /** @type {string} */ path) {
  const server = await serveSite(folder, '/');
  const browser = await puppeteer.launch({ executablePath: await findBrowser(), args: CHROMIUM_FLAGS });
  try {
    const page = await browser.newPage();
    const report = await lighthouse(server.address + path, { logLevel: 'error' }, undefined, page);
    const { lhr } = /** @type {NonNullable<typeof report>} */ (report);
    if (lhr.runtimeError)
      throw new Error(`Lighthouse could not measure ${path || 'the page'}: ${lhr.runtimeError.message}`);
    return lhr;
  } finally {
    await browser.close();
    await server.close();
  }
}

/** @param {string} name @param {Result[]} results @returns {Figure[]} */
function figuresOf(name, results) {
  const score = (/** @type {string} */ id) => results.map(({ categories }) => 100 * (categories[id].score ?? 0));
  const time = (/** @type {string} */ id) => results.map(({ audits }) => audits[id].numericValue ?? NaN);
  const index = spread(results.map(({ environment }) => environment.benchmarkIndex)).value;
  return [
    ...Object.entries(CATEGORIES).map(([key, id]) => ({
      name: `lighthouse.${name}.${key}`,
      unit: '',
      ...spread(score(id)),
      note: key === 'performance' ? `mobile preset; goal ${goalOf(name)}; benchmark index ${index}` : 'goal 95',
    })),
    ...Object.entries(TIMES).map(([key, id]) => ({
      name: `lighthouse.${name}.${key}`,
      unit: 'ms',
      ...spread(time(id)),
    })),
  ];
}

function goalOf(/** @type {string} */ name) {
  return name === 'page' ? 80 : 95;
}
