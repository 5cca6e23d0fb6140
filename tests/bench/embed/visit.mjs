/** A page with widgets in a browser of its own, which can be measured while they are seen and while they are not. */

import { setTimeout as pause } from 'node:timers/promises';
import { chromium } from '@playwright/test';
import { CHROMIUM_FLAGS, findBrowser } from '../../../scripts/setup/browser.mjs';
import { VIEW } from './contestants.mjs';
import { costOf } from './processes.mjs';

const SETTLING_MS = 500;
/** Of a processor: what a browser takes for itself. */
const RESTING_SHARE = 0.1;
/** With what is drawn slowly, and with what was not drawn yet. */
const TIMEOUT_MS = 20_000;
const LONG_TIMEOUT_MS = 120_000;

/**
 * @typedef {object} Window
 * @property {number} seconds
 * @property {number} frames that were begun, whichever thread draws
 * @property {number} mainMs milliseconds of work on the page's main thread
 * @property {number} processorSeconds of the page's process and the one that draws
 *
 * @typedef {object} Loaded
 * @property {number} first ms from the navigation to the first picture of a widget
 * @property {number} all ms until all have theirs
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
   * Opens a page as somebody does who was never there, and waits until all widgets stand.
   *
   * @param {string} address @param {string | undefined} event @param {number} count of widgets
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
   * With the widgets in view: so long at least, and until so many frames were drawn, and on a slow machine not much longer.
   *
   * @param {number} frames @param {number} ms @returns {Promise<Window>}
   */
  async measureSeen(frames, ms) {
    await this.scroll(0);
    if (this.isAnimated) await this.waitForFrame();
    const begin = performance.now();
    let window = await this.measure(ms);
    while (this.isAnimated && window.frames < frames && performance.now() - begin < TIMEOUT_MS)
      window = together(window, await this.measure(ms));
    if (this.isAnimated && window.frames === 0) throw new Error(`${this.page?.url()} draws nothing.`);
    return window;
  }

  /**
   * With the widgets out of view, once they have come to rest, or have had time enough for it.
   *
   * @param {number} ms @returns {Promise<Window>}
   */
  async measureUnseen(ms) {
    await this.scroll(1);
    const begin = performance.now();
    let window = await this.measure(SETTLING_MS);
    while (!isAtRest(window) && performance.now() - begin < TIMEOUT_MS) window = await this.measure(SETTLING_MS);
    return this.measure(ms);
  }

  /** What asks the page for its frames stands outside of what is measured of it. @param {number} ms @returns {Promise<Window>} */
  async measure(ms) {
    const framesBefore = await this.frames();
    const before = await this.state();
    await pause(ms);
    const after = await this.state();
    return {
      seconds: after.seconds - before.seconds,
      frames: (await this.frames()) - framesBefore,
      mainMs: 1000 * (after.taskSeconds - before.taskSeconds),
      processorSeconds: after.cost.seconds - before.cost.seconds,
    };
  }

  async waitForFrame() {
    const begin = performance.now();
    const first = await this.frames();
    while ((await this.frames()) === first && performance.now() - begin < LONG_TIMEOUT_MS) await pause(SETTLING_MS);
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

  /** Drawn so far, on whichever thread. */
  async frames() {
    const page = this.openPage();
    // The page is asked only where it draws itself.
    const [worker] = page.workers();
    return worker ? worker.evaluate(framesSoFar) : page.evaluate(framesSoFar);
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
    mainMs: one.mainMs + other.mainMs,
    processorSeconds: one.processorSeconds + other.processorSeconds,
  };
}

/** The process that draws may still have work when the page asks for no more. @param {Window} window */
function isAtRest({ seconds, frames, processorSeconds }) {
  return frames === 0 && processorSeconds < RESTING_SHARE * seconds;
}

/** Runs in a page before anything of it: notes when widgets stand, and why they do not. @param {string | undefined} event */
function watch(event) {
  const scope = /** @type {any} */ (window);
  scope.arrivals = [];
  const isWidget = (/** @type {Event} */ { target }) => target instanceof Element && target.matches('.widget');
  const arrive = (/** @type {Event} */ happened) => {
    // Presented by the time the next frame begins.
    if (isWidget(happened)) requestAnimationFrame(() => scope.arrivals.push(performance.now()));
  };
  const fail = (/** @type {any} */ happened) => {
    if (isWidget(happened)) scope.failure = String(happened.detail?.error ?? happened.detail?.type);
  };
  if (event) document.addEventListener(event, arrive, true);
  document.addEventListener('error', fail, true);
}

/** Runs in a page: waits until as many widgets stand, or one never will. @param {number} count @returns {Promise<string | undefined>} */
async function arrived(count) {
  const scope = /** @type {any} */ (window);
  while (scope.arrivals.length < count && !scope.failure) await new Promise(requestAnimationFrame);
  return scope.failure;
}

/** Runs on a page or in a worker: counts the frames for which anybody asked, however many asked for the same. */
function countFrames() {
  const scope = /** @type {any} */ (globalThis);
  const ask = requestAnimationFrame.bind(globalThis);
  let latest = 0;
  scope.frames = 0;
  scope.requestAnimationFrame = (/** @type {FrameRequestCallback} */ callback) =>
    ask((now) => {
      if (now > latest) scope.frames += 1;
      latest = now;
      callback(now);
    });
}

/** @returns {number} */
function framesSoFar() {
  return /** @type {any} */ (globalThis).frames ?? 0;
}
