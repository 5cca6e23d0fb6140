/** Loads the built site once with an empty cache, and detects the first smoke. */

/**
 * @typedef {object} Load
 * @property {number} firstSmoke ms from the navigation to the presented frame with the first bodies
 * @property {number} stageAt ms from the navigation to a stage with scene and simulator
 * @property {number} bytes of JavaScript and WASM on the wire by then
 * @property {number} workMs duration of a fixed loop in the same browser, which tells the speed of the machine
 */

/**
 * @param {import('@playwright/test').Browser} browser
 * @param {string} address
 * @returns {Promise<Load>}
 */
export async function loadOnce(browser, address) {
  const context = await browser.newContext({ viewport: { width: 800, height: 450 }, deviceScaleFactor: 1 });
  try {
    const page = await context.newPage();
    page.setDefaultTimeout(120_000);
    const workMs = await page.evaluate(work);
    await page.addInitScript(watch);
    await page.goto(address, { waitUntil: 'commit' });
    await page.waitForFunction(() => 'firstSmoke' in window);
    const load = await page.evaluate(
      () => /** @type {Window & { firstSmoke: Load }} */ (/** @type {unknown} */ (window)).firstSmoke,
    );
    return { ...load, workMs };
  } finally {
    await context.close();
  }
}

/** A fixed loop that tells how fast the machine is, ms. */
function work() {
  const start = performance.now();
  let state = 1;
  for (let round = 0; round < 20_000_000; round++) state = (Math.imul(state, 1664525) + 1013904223) | 0;
  return state === 0 ? 0 : performance.now() - start;
}

/**
 * Runs in the page before its scripts: records when the stage exists, and when the frame after the first bodies begins.
 */
function watch() {
  Object.defineProperty(window, 'cartoonSmoke', {
    configurable: true,
    set(stage) {
      Object.defineProperty(window, 'cartoonSmoke', { value: stage });
      const stageAt = performance.now();
      const end = stage.on('frame', (/** @type {{ bodiesDrawn: number }} */ { bodiesDrawn }) => {
        if (bodiesDrawn === 0) return;
        end();
        // A frame is presented when the next one begins.
        requestAnimationFrame(() => {
          const firstSmoke = performance.now();
          const code = performance.getEntriesByType('resource').filter(({ name }) => /\.(js|wasm)$/.test(name));
          const sizes = code.map((entry) => /** @type {PerformanceResourceTiming} */ (entry).encodedBodySize);
          const bytes = sizes.reduce((sum, size) => sum + size, 0);
          Object.assign(window, { firstSmoke: { stageAt, firstSmoke, bytes } });
        });
      });
    },
  });
}
