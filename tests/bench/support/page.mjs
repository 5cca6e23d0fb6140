/** Runs a suite in a page of a headless Chromium, by default with SwiftShader. */

import { chromium } from '@playwright/test';
import { createServer } from 'vite';
import { inRoot } from '../../../scripts/lib/paths.mjs';
import { CHROMIUM_FLAGS, findBrowser } from '../../../scripts/setup/browser.mjs';

/**
 * Exact heap sizes and explicit garbage collection: without them growth cannot be distinguished from garbage. WASM uses
 * the optimizing compiler immediately: its code is twice as fast, and on a busy machine tier-up may occur after the
 * warm-up.
 */
const MEASURING_FLAGS = ['--enable-precise-memory-info', '--js-flags=--expose-gc --no-liftoff'];

/**
 * @typedef {import('../../../scripts/bench/table.mjs').Figure} Figure
 * @typedef {object} Choice
 * @property {boolean} quick fewer rounds and repetitions
 * @property {(line: string) => void} say shows the current measurement
 */

/**
 * Imports a module in a page by its path in the repository and calls its `measure(quick)`.
 *
 * @param {`/${string}`} path
 * @param {Choice} choice
 * @param {import('vite').Plugin[]} [plugins] added to the server of the page
 * @param {string[]} [flags] of Chromium
 * @returns {Promise<Figure[]>}
 */
export async function measureInPage(path, { quick, say }, plugins = [], flags = CHROMIUM_FLAGS) {
  const measure = `import(${JSON.stringify(path)}).then((suite) => suite.measure(${quick}))`;
  return /** @type {Figure[]} */ (await evaluateInPage(measure, say, plugins, flags));
}

/**
 * @param {string} expression evaluated in a page without product code, except for the server's modules
 * @param {(line: string) => void} say the page's `sayProgress`
 * @param {import('vite').Plugin[]} [plugins] added to the server of the page
 * @param {string[]} [flags] of Chromium
 * @param {number} [deviceScaleFactor] of the page
 * @returns {Promise<unknown>}
 */
export async function evaluateInPage(expression, say, plugins = [], flags = CHROMIUM_FLAGS, deviceScaleFactor = 1) {
  const configFile = inRoot('tests/bench/vite.config.ts');
  const server = await createServer({ configFile, plugins, logLevel: 'error' });
  const browser = await chromium.launch({
    executablePath: await findBrowser(),
    args: [...flags, ...MEASURING_FLAGS],
  });
  try {
    await server.listen();
    const page = await browser.newPage({ viewport: { width: 640, height: 360 }, deviceScaleFactor });
    page.setDefaultTimeout(0);
    await page.exposeFunction('sayProgress', say);
    await page.goto(new URL('/tests/support/blank.html', server.resolvedUrls?.local[0]).href);
    return await page.evaluate(expression);
  } finally {
    await browser.close();
    await server.close();
  }
}
