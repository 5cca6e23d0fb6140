/**
 * `npm run bench -- puff`: `puff()` as published, beside canvas-confetti in the same page: download sizes, time to the
 * first smoke, main-thread time of 1 and 20 calls, and what 500 calls leave behind.
 */

import { existsSync, mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { setTimeout as pause } from 'node:timers/promises';
import { chromium } from '@playwright/test';
import { run as runCommand } from '../../scripts/lib/command.mjs';
import { inRoot } from '../../scripts/lib/paths.mjs';
import { UserError } from '../../scripts/lib/userError.mjs';
import { CHROMIUM_FLAGS, findBrowser } from '../../scripts/setup/browser.mjs';
import * as packaged from '../../scripts/setup/package.mjs';
import { serveSite } from '../../scripts/site/serve.mjs';
import { spread } from './support/spread.mjs';

/** @typedef {import('../../scripts/bench/table.mjs').Figure} Figure */

const FOLDER = '.cache/bench-puff';
const CONFETTI = 'canvas-confetti';
const VERSION = '1.9.4';
const CONFETTI_FILE = `${FOLDER}/node_modules/${CONFETTI}/dist/confetti.browser.js`;
const VIEW = { width: 640, height: 360 };
const ROUNDS = 5;
const CALLS = 500;
/** Calls at a time. */
const BATCH = 25;
/** Between preload() and a call, milliseconds. */
const SETTLE_MS = 1000;
/** After this time without smoke everything is gone. */
const IDLE_MS = 13_000;

const PAGE = `<!doctype html><html lang="en"><meta charset="utf-8"><title>Bench</title><link rel="icon" href="data:,">
  <button style="margin: 120px 250px">Press</button>
  <script type="module">
    import { puff } from '/package/dist/puff.js';
    window.puff = puff;
  </script>`;
const WITH_CONFETTI = `${PAGE}<script src="/${CONFETTI_FILE}"></script>`;

/**
 * @param {import('./support/page.mjs').Choice} choice
 * @returns {Promise<Figure[]>}
 */
export async function run({ quick, say }) {
  if (!packaged.isFresh()) await packaged.bring(say);
  await bringConfetti(say);
  writeFileSync(inRoot(`${FOLDER}/puff.html`), PAGE);
  writeFileSync(inRoot(`${FOLDER}/both.html`), WITH_CONFETTI);
  const rounds = quick ? 3 : ROUNDS;
  const server = await serveSite(inRoot('.'), '/');
  const browser = await chromium.launch({
    executablePath: await findBrowser(),
    args: [...CHROMIUM_FLAGS, '--js-flags=--expose-gc', '--enable-precise-memory-info'],
  });
  const open = (/** @type {string} */ page) => openPage(browser, `${server.address}${FOLDER}/${page}.html`);
  try {
    say('download and first smoke');
    const starts = await measureStarts(open, server.sent, rounds);
    say('main thread');
    const costs = await measureCosts(open, rounds, say);
    say(`${CALLS} calls`);
    return [...starts, ...costs, ...(await measureLeaks(open, quick ? CALLS / 5 : CALLS))];
  } finally {
    await browser.close();
    await server.close();
  }
}

/** @param {(line: string) => void} say */
async function bringConfetti(say) {
  if (existsSync(inRoot(CONFETTI_FILE))) return;
  say(`fetching ${CONFETTI}`);
  const folder = inRoot(FOLDER);
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, 'package.json'), JSON.stringify({ private: true, dependencies: { [CONFETTI]: VERSION } }));
  const { status, output } = await runCommand('npm', ['install', '--ignore-scripts', '--no-audit', '--no-fund'], {
    folder,
  });
  if (status !== 0) throw new UserError(`${CONFETTI} could not be fetched from npm.`, output);
}

/** @param {import('@playwright/test').Browser} browser @param {string} address */
async function openPage(browser, address) {
  const context = await browser.newContext({ viewport: VIEW, deviceScaleFactor: 1 });
  const page = await context.newPage();
  page.setDefaultTimeout(120_000);
  await page.addInitScript(helpers);
  await page.goto(address);
  await page.waitForFunction(() => 'puff' in window);
  return page;
}

/** Runs in the page. */
function helpers() {
  const scope = /** @type {any} */ (window);
  scope.contexts = 0;
  const native = /** @type {any} */ (HTMLCanvasElement.prototype.getContext);
  /** @this {HTMLCanvasElement} @param {unknown[]} given */
  HTMLCanvasElement.prototype.getContext = /** @type {any} */ (
    function (...given) {
      scope.contexts += 1;
      return native.apply(this, given);
    }
  );
  /** Milliseconds from a call until its smoke is on the canvas. */
  scope.untilSmoke = async () => {
    const copy = new OffscreenCanvas(80, 45).getContext('2d', { willReadFrequently: true });
    const begin = performance.now();
    const over = scope.puff(document.querySelector('button'));
    for (;;) {
      await new Promise(requestAnimationFrame);
      const canvas = document.querySelector('canvas');
      if (!canvas || canvas.width === 0) continue;
      copy.clearRect(0, 0, 80, 45);
      copy.drawImage(canvas, 0, 0, 80, 45);
      if (copy.getImageData(0, 0, 80, 45).data.some((/** @type {number} */ byte) => byte > 0)) break;
    }
    const seconds = performance.now() - begin;
    await over;
    return seconds;
  };
  /** Number of frames of the page while an effect runs. */
  scope.framesOf = async (/** @type {() => Promise<unknown>} */ act) => {
    let frames = 0;
    let isOver = false;
    const count = () => {
      frames += 1;
      if (!isOver) requestAnimationFrame(count);
    };
    requestAnimationFrame(count);
    await act();
    isOver = true;
    return frames;
  };
}

/** @typedef {import('@playwright/test').Page} Page */
/** @typedef {(page: string) => Promise<Page>} Open */

/** @param {Open} open @param {{ file: string, bytes: number }[]} sent @param {number} rounds @returns {Promise<Figure[]>} */
async function measureStarts(open, sent, rounds) {
  const cold = [];
  const warm = [];
  let first = 0;
  let total = 0;
  for (let round = 0; round < rounds; round++) {
    sent.length = 0;
    const page = await open('puff');
    const bytes = () => sent.filter(({ file }) => /\.(js|wasm)$/.test(file)).reduce((sum, each) => sum + each.bytes, 0);
    first = bytes();
    cold.push(await page.evaluate('untilSmoke()'));
    total = bytes();
    await page.context().close();
    const preloaded = await open('puff');
    await preloaded.evaluate('puff.preload()');
    // The graphics process still compiles, and releases the page before.
    await pause(SETTLE_MS);
    warm.push(await preloaded.evaluate('untilSmoke()'));
    await preloaded.context().close();
  }
  return [
    { name: 'puff.firstKb', value: first / 1000, unit: 'kB', note: 'gzip, before the first call; at most 6' },
    { name: 'puff.totalKb', value: total / 1000, unit: 'kB', note: 'gzip, with worker and simulator' },
    { name: 'puff.coldMs', ...spread(/** @type {number[]} */ (cold)), unit: 'ms', note: 'to the first smoke' },
    {
      name: 'puff.preloadedMs',
      ...spread(/** @type {number[]} */ (warm)),
      unit: 'ms',
      note: 'a second after preload(); at most 150',
    },
  ];
}

/** One page, so that both draw in the same window. */
const CONTESTS = /** @type {const} */ ([
  ['puff', 1, "puff(document.querySelector('button'))"],
  ['confetti', 1, 'confetti()'],
  ['puff', 20, 'Promise.all(Array.from({ length: 20 }, (_, at) => puff({ x: 30 * at, y: 200 })))'],
  ['confetti', 20, 'Promise.all(Array.from({ length: 20 }, () => confetti()))'],
]);
const IDLE = 'new Promise((resolve) => setTimeout(resolve, 2000))';

/**
 * Two pages of a host: one that is at rest, in which a frame is one that the effect draws, and one that animates
 * something itself, in which the time of its own frames counts.
 *
 * @param {Open} open @param {number} rounds @param {(line: string) => void} say @returns {Promise<Figure[]>}
 */
async function measureCosts(open, rounds, say) {
  const page = await open('both');
  const session = await page.context().newCDPSession(page);
  // The time of the processor: on a machine without a GPU, the worker takes it from the page.
  await session.send('Performance.enable', { timeDomain: 'threadTicks' });
  await page.evaluate('puff.preload()');
  await page.evaluate('Promise.all([puff(), confetti()])');
  // Both draw in a worker.
  const workers = page.workers();
  for (const worker of workers) await worker.evaluate(countPictures);
  const milliseconds = async () =>
    1000 * valueOf((await session.send('Performance.getMetrics')).metrics, 'TaskDuration');
  const drawn = async () => {
    const all = await Promise.all(workers.map((worker) => worker.evaluate('pictures')));
    return /** @type {number[]} */ (all).reduce((sum, each) => sum + each, 0);
  };
  /** @type {Record<string, number[]>} */
  const found = {};
  const note = (/** @type {string} */ name, /** @type {number} */ value) => (found[name] ??= []).push(value);
  for (let round = 0; round < rounds; round++) {
    say(`main thread, round ${round + 1} of ${rounds}`);
    const animated = async (/** @type {string} */ code) => {
      const before = await milliseconds();
      const frames = /** @type {number} */ (await page.evaluate(`framesOf(() => ${code})`));
      return ((await milliseconds()) - before) / frames;
    };
    note('page.main0Ms', await animated(IDLE));
    for (const [what, calls, code] of CONTESTS) {
      const [before, framesBefore] = [await milliseconds(), await drawn()];
      await page.evaluate(code);
      const spent = (await milliseconds()) - before;
      note(`${what}.main${calls}Ms`, spent / ((await drawn()) - framesBefore));
      note(`${what}.main${calls}TotalMs`, spent);
      note(`${what}.animated${calls}Ms`, await animated(code));
    }
  }
  await page.context().close();
  const ratios = [1, 20].flatMap((calls) =>
    ['main', 'animated'].map((measure) => {
      const name = `${measure}${calls}`;
      const values = found[`puff.${name}Ms`].map((ms, round) => ms / found[`confetti.${name}Ms`][round]);
      const goal = name === 'main1' ? '; at most 1' : '';
      return { name: `puff.${name}Ratio`, ...spread(values), unit: 'x', note: `of ${CONFETTI} ${VERSION}${goal}` };
    }),
  );
  const noteOf = (/** @type {string} */ name) => {
    if (name.endsWith('TotalMs')) return 'processor time of the main thread for the whole effect, page at rest';
    const frames = /\.main[1-9]/.test(name) ? 'the effect, page at rest' : 'the page, which animates itself';
    return `processor time of the main thread for each frame of ${frames}`;
  };
  const times = Object.entries(found).map(([name, values]) => ({
    name,
    ...spread(values),
    unit: 'ms',
    note: noteOf(name),
  }));
  return [...times, ...ratios];
}

/** Runs in a worker, and counts the pictures that it presents: by a bitmap, or by clearing and drawing on a 2D canvas. */
function countPictures() {
  const scope = /** @type {any} */ (globalThis);
  scope.pictures = 0;
  const count = (/** @type {any} */ prototype, /** @type {string} */ method) => {
    const native = prototype[method];
    /** @this {unknown} @param {unknown[]} given */
    prototype[method] = function (...given) {
      scope.pictures += 1;
      return native.apply(this, given);
    };
  };
  count(ImageBitmapRenderingContext.prototype, 'transferFromImageBitmap');
  count(OffscreenCanvasRenderingContext2D.prototype, 'clearRect');
}

/** @param {Open} open @param {number} count @returns {Promise<Figure[]>} */
async function measureLeaks(open, count) {
  const page = await open('puff');
  const session = await page.context().newCDPSession(page);
  await session.send('Performance.enable');
  const batch = () =>
    page.evaluate(
      (calls) =>
        Promise.all(
          Array.from({ length: calls }, (_, at) =>
            /** @type {any} */ (window).puff({ x: 20 * at, y: 100 }, { effect: 'pop', count: 4 }),
          ),
        ),
      BATCH,
    );
  const state = async () => {
    await pause(IDLE_MS);
    await page.evaluate('gc()');
    const { metrics } = await session.send('Performance.getMetrics');
    const [listeners, nodes, heap] = ['JSEventListeners', 'Nodes', 'JSHeapUsedSize'].map((name) =>
      valueOf(metrics, name),
    );
    const [canvases, contexts] = /** @type {[number, number]} */ (
      await page.evaluate('[document.querySelectorAll("canvas").length, contexts]')
    );
    return { listeners, nodes, heap: heap / 1e6, canvases, contexts, workers: page.workers().length };
  };
  // The modules stay in memory.
  await batch();
  const before = await state();
  for (let calls = 0; calls < count; calls += BATCH) await batch();
  const after = await state();
  await page.context().close();
  const note = `more after ${count} calls, when idle`;
  return [
    { name: 'puff.heapMb', value: after.heap - before.heap, unit: 'MB', note },
    .../** @type {const} */ (['listeners', 'nodes', 'canvases', 'contexts', 'workers']).map((name) => ({
      name: `puff.${name}`,
      value: after[name] - before[name],
      unit: '',
      note,
    })),
  ];
}

/** @param {{ name: string, value: number }[]} metrics @param {string} wanted */
function valueOf(metrics, wanted) {
  return metrics.find(({ name }) => name === wanted)?.value ?? 0;
}
