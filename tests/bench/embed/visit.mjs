/** A page with widgets in a separate browser, measured in and out of view. */

import { setTimeout as pause } from 'node:timers/promises';
import { chromium } from '@playwright/test';
import { CHROMIUM_FLAGS, findBrowser } from '../../../scripts/setup/browser.mjs';
import { VIEW } from './contestants.mjs';
import { costOf } from './processes.mjs';

const SETTLING_MS = 500;
/** Share of a core that an idle browser uses. */
const RESTING_SHARE = 0.1;
/** Timeouts for slow frames, for rest, and for the first frame. */
const SEEN_MS = 5_000;
const TIMEOUT_MS = 20_000;
const LONG_TIMEOUT_MS = 120_000;

/**
 * @typedef {object} Window
 * @property {number} seconds
 * @property {number} frames in which something was drawn, on either thread
 * @property {number} drawings of widgets that were copied to their canvases; 0 if a single one draws on its own
 * @property {number} frameSeconds in which the frames and drawings were counted, by the clock of their thread
 * @property {number} mainMs milliseconds of work on the page's main thread
 * @property {number} processorSeconds of the renderer process and the GPU process
 *
 * @typedef {object} Loaded
 * @property {number} first ms from the navigation to the first picture of a widget
 * @property {number} all ms until all widgets have a picture
 */

export class Visit {
  /** @param {import('@playwright/test').Browser} browser @param {import('@playwright/test').CDPSession} session */
  constructor(browser, session) {
    this.browser = browser;
    this.session = session;
  }

  static async begin() {
    const browser = await chromium.launch({ executablePath: await findBrowser(), args: CHROMIUM_FLAGS });
    return new Visit(browser, await browser.newBrowserCDPSession());
  }

  /**
   * Opens a page with an empty cache and waits until all widgets are ready.
   *
   * @param {string} address
   * @param {string | undefined} event
   * @param {number} count of widgets
   * @returns {Promise<Loaded>}
   */
  async load(address, event, count) {
    await this.page?.context().close();
    const context = await this.browser.newContext({ viewport: VIEW, deviceScaleFactor: 1 });
    this.page = await context.newPage();
    this.page.setDefaultTimeout(120_000);
    this.metrics = await context.newCDPSession(this.page);
    await this.metrics.send('Performance.enable');
    await this.page.addInitScript(countFrames);
    await this.page.addInitScript(watch, event);
    this.page.on('worker', (worker) => void worker.evaluate(countFrames));
    await this.page.goto(address);
    this.isAnimated = event !== undefined;
    const failure = await this.page.evaluate(arrived, event ? count : 0);
    if (failure) throw new Error(`${address} has no picture: ${failure}`);
    const arrivals = await this.page.evaluate(() => /** @type {number[]} */ (/** @type {any} */ (window).arrivals));
    return { first: arrivals[0] ?? 0, all: arrivals[count - 1] ?? 0 };
  }

  /**
   * With the widgets in view: at least `ms`, then until `frames` frames are drawn, for at most 5 s in total.
   *
   * @param {number} frames
   * @param {number} ms
   * @returns {Promise<Window>}
   */
  async measureSeen(frames, ms) {
    await this.scroll(0);
    if (this.isAnimated) await this.waitForFrame();
    const begin = performance.now();
    let window = await this.measure(ms);
    while (this.isAnimated && window.frames < frames && performance.now() - begin < SEEN_MS)
      window = together(window, await this.measure(ms));
    if (this.isAnimated && window.frames === 0) throw new Error(`${this.page?.url()} draws nothing.`);
    return window;
  }

  /**
   * With the widgets out of view, after they are idle or a timeout.
   *
   * @param {number} ms
   * @returns {Promise<Window>}
   */
  async measureUnseen(ms) {
    await this.scroll(1);
    const begin = performance.now();
    let window = await this.measure(SETTLING_MS);
    while (!isAtRest(window) && performance.now() - begin < TIMEOUT_MS) window = await this.measure(SETTLING_MS);
    return this.measure(ms);
  }

  /**
   * Reading the frame counts is outside the measured interval.
   * @param {number} ms
   * @returns {Promise<Window>}
   */
  async measure(ms) {
    const countedBefore = await this.counted();
    const before = await this.state();
    await pause(ms);
    const after = await this.state();
    const counted = await this.counted();
    return {
      seconds: after.seconds - before.seconds,
      frames: counted.frames - countedBefore.frames,
      drawings: counted.drawings - countedBefore.drawings,
      frameSeconds: counted.seconds - countedBefore.seconds,
      mainMs: 1000 * (after.taskSeconds - before.taskSeconds),
      processorSeconds: after.cost.seconds - before.cost.seconds,
    };
  }

  async waitForFrame() {
    const begin = performance.now();
    const { frames } = await this.counted();
    while ((await this.counted()).frames === frames && performance.now() - begin < LONG_TIMEOUT_MS)
      await pause(SETTLING_MS);
  }

  /** @param {0 | 1} end of the page */
  scroll(end) {
    return this.openPage().evaluate((where) => scrollTo(0, where * document.body.scrollHeight), end);
  }

  async megabytes() {
    return (await costOf(this.session)).megabytes;
  }

  async end() {
    await this.browser.close();
  }

  async state() {
    const { metrics = [] } = (await this.metrics?.send('Performance.getMetrics')) ?? {};
    const taskSeconds = metrics.find(({ name }) => name === 'TaskDuration')?.value ?? 0;
    return { cost: await costOf(this.session), taskSeconds, seconds: performance.now() / 1000 };
  }

  /** What was drawn so far, on either thread. */
  async counted() {
    const page = this.openPage();
    // Query the page only if there is no worker.
    const [worker] = page.workers();
    return worker ? worker.evaluate(countedSoFar) : page.evaluate(countedSoFar);
  }

  openPage() {
    if (!this.page) throw new Error('Nothing was loaded.');
    return this.page;
  }
}

/** @param {Window} one @param {Window} other @returns {Window} */
function together(one, other) {
  return {
    seconds: one.seconds + other.seconds,
    frames: one.frames + other.frames,
    drawings: one.drawings + other.drawings,
    frameSeconds: one.frameSeconds + other.frameSeconds,
    mainMs: one.mainMs + other.mainMs,
    processorSeconds: one.processorSeconds + other.processorSeconds,
  };
}

/**
 * The GPU process may still be busy after the page's last request.
 * @param {Window} window
 */
function isAtRest({ seconds, frames, processorSeconds }) {
  return frames === 0 && processorSeconds < RESTING_SHARE * seconds;
}

/**
 * Runs in a page before its scripts: records when widgets are ready, and why they fail.
 * @param {string | undefined} event
 */
function watch(event) {
  const scope = /** @type {any} */ (window);
  scope.arrivals = [];
  const isWidget = (/** @type {Event} */ { target }) => target instanceof Element && target.matches('.widget');
  const arrive = (/** @type {Event} */ happened) => {
    // The picture is presented when the next frame begins.
    if (isWidget(happened)) requestAnimationFrame(() => scope.arrivals.push(performance.now()));
  };
  const fail = (/** @type {any} */ happened) => {
    if (isWidget(happened)) scope.failure = String(happened.detail?.error ?? happened.detail?.type);
  };
  if (event) document.addEventListener(event, arrive, true);
  document.addEventListener('error', fail, true);
}

/**
 * Runs in a page: waits until all widgets are ready, or one fails.
 * @param {number} count
 * @returns {Promise<string | undefined>}
 */
async function arrived(count) {
  const scope = /** @type {any} */ (window);
  while (scope.arrivals.length < count && !scope.failure) await new Promise(requestAnimationFrame);
  return scope.failure;
}

/** Runs in a page or worker: counts frames in which something is drawn, and pictures copied to canvases. */
function countFrames() {
  const scope = /** @type {any} */ (globalThis);
  const ask = requestAnimationFrame.bind(globalThis);
  let latest = 0;
  let isCounted = true;
  scope.frames = scope.drawings = 0;
  scope.requestAnimationFrame = (/** @type {FrameRequestCallback} */ callback) =>
    ask((now) => {
      if (now > latest) isCounted = false;
      latest = now;
      callback(now);
    });
  const draw = () => {
    if (!isCounted) scope.frames += 1;
    isCounted = true;
  };
  const copy = () => (scope.drawings += 1);
  const watched = /** @type {const} */ ([
    ['WebGL2RenderingContext', 'drawElements', draw],
    ['WebGL2RenderingContext', 'drawArrays', draw],
    ['CanvasRenderingContext2D', 'clearRect', draw],
    ['OffscreenCanvasRenderingContext2D', 'clearRect', draw],
    ['CanvasRenderingContext2D', 'drawImage', copy],
    ['ImageBitmapRenderingContext', 'transferFromImageBitmap', copy],
  ]);
  for (const [context, method, happen] of watched) {
    // A worker does not have all of them.
    const { prototype } = scope[context] ?? { prototype: {} };
    const original = prototype[method];
    prototype[method] = /** @this {any} */ function (/** @type {any[]} */ ...given) {
      happen();
      return original.apply(this, given);
    };
  }
}

/** @returns {{ frames: number, drawings: number, seconds: number }} */
function countedSoFar() {
  const { frames = 0, drawings = 0 } = /** @type {any} */ (globalThis);
  return { frames, drawings, seconds: performance.now() / 1000 };
}
