/** Runs a suite inside one page of a headless Chromium that draws with SwiftShader. */

import { chromium } from '@playwright/test';
import { createServer } from 'vite';
import { inRoot } from '../../../scripts/lib/paths.mjs';
import { CHROMIUM_FLAGS, findBrowser } from '../../../scripts/setup/browser.mjs';

/**
 * Heap sizes to the byte, and a collection when asked for: without them growth cannot be told from garbage. WASM goes
 * through the optimising compiler at once: its code is twice as fast, and on a busy machine the switch to it may come
 * after the warming.
 */
const MEASURING_FLAGS = ['--enable-precise-memory-info', '--js-flags=--expose-gc --no-liftoff'];

/**
 * @typedef {import('../../../scripts/bench/table.mjs').Figure} Figure
 * @typedef {object} Choice
 * @property {boolean} quick fewer rounds and repetitions
 * @property {(line: string) => void} say shows what is being measured
 */

/**
 * Imports a module by its path in the repository inside a page and lets its `measure(quick)` make the figures.
 *
 * @param {`/${string}`} path
 * @param {Choice} choice
 * @param {import('vite').Plugin[]} [plugins] added to the server of the page
 * @returns {Promise<Figure[]>}
 */
export async function measureInPage(path, { quick, say }, plugins = []) {
  const measure = `import(${JSON.stringify(path)}).then((suite) => suite.measure(${quick}))`;
  return /** @type {Figure[]} */ (await evaluateInPage(measure, say, plugins));
}

/**
 * @param {string} expression evaluated in a page that has nothing of ours on it but the server's modules
 * @param {(line: string) => void} say the page's `sayProgress`
 * @param {import('vite').Plugin[]} [plugins] added to the server of the page
 * @returns {Promise<unknown>}
 */
export async function evaluateInPage(expression, say, plugins = []) {
  const configFile = inRoot('tests/bench/vite.config.ts');
  const server = await createServer({ configFile, plugins, logLevel: 'error' });
  const browser = await chromium.launch({
    executablePath: await findBrowser(),
    args: [...CHROMIUM_FLAGS, ...MEASURING_FLAGS],
  });
  try {
    await server.listen();
    const page = await browser.newPage({ viewport: { width: 640, height: 360 }, deviceScaleFactor: 1 });
    page.setDefaultTimeout(0);
    await page.exposeFunction('sayProgress', say);
    await page.goto(new URL('/tests/support/blank.html', server.resolvedUrls?.local[0]).href);
    return await page.evaluate(expression);
  } finally {
    await browser.close();
    await server.close();
  }
}
