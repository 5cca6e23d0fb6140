/** Loads the built site once with an empty cache, and detects the first smoke. */

/**
 * @typedef {object} Load
 * @property {number} firstSmoke ms from the navigation to the presented frame with the first bodies
 * @property {number} stageAt ms from the navigation to a stage with scene and simulator
 * @property {number} bytes of JavaScript and WASM on the wire by then
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
    await page.addInitScript(watch);
    await page.goto(address, { waitUntil: 'commit' });
    await page.waitForFunction(() => 'firstSmoke' in window);
    return await page.evaluate(
      () => /** @type {Window & { firstSmoke: Load }} */ (/** @type {unknown} */ (window)).firstSmoke,
    );
  } finally {
    await context.close();
  }
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
