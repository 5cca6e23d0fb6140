/** An article with smoke in its figures: the effect on the performance of the page. */
import { readFileSync } from 'node:fs';
import type { Page } from '@playwright/test';
import type { CartoonSmokeElement } from '../../../../src/page/element/cartoonSmokeElement.ts';
import { expect, frames, MODULES, scrollPage, test } from '../../../support/embed.ts';

const SOURCE = readFileSync(new URL('../../../../examples/article/index.html', import.meta.url), 'utf8');
const ARTICLE = /<body>([^]*)<\/body>/.exec(SOURCE)![1].replace(/src="(tea|fire)/g, 'src="/examples/article/$1');
/** Text before the first figure, long enough to keep it out of the loading margin on any screen. */
const LONG = ARTICLE.replace('<figure>', `${/<p class="first">[^]*?<\/p>/.exec(ARTICLE)![0].repeat(8)}<figure>`);
const STYLE = '<link rel="stylesheet" href="/examples/article/style.css" />';
/** Measures layout shifts and blocking time from the start of the page. */
const METER = `<script>
  window.cost = { shift: 0, blocking: 0 };
  const watch = (type, note) => new PerformanceObserver((list) => list.getEntries().forEach(note)).observe({ type, buffered: true });
  watch('layout-shift', ({ value }) => (window.cost.shift += value));
  watch('longtask', ({ duration }) => (window.cost.blocking += Math.max(0, duration - 50)));
</script>`;

interface Cost {
  shift: number;
  blocking: number;
}

/** The values after all figures were scrolled into view and play. */
async function costOf(page: Page): Promise<Cost> {
  for (const figure of await page.locator('figure').all()) {
    await figure.scrollIntoViewIfNeeded();
    await figure.locator('cartoon-smoke').evaluate(async (smoke: CartoonSmokeElement) => {
      if (!customElements.get('cartoon-smoke')) return;
      await smoke.ready;
      const goal = (await smoke.stats()).steps + 10;
      while ((await smoke.stats()).steps < goal) await new Promise(requestAnimationFrame);
    });
  }
  await frames(page, 2);
  return page.evaluate(() => Reflect.get(window, 'cost') as Cost);
}

test('loads nothing large before its figures are near, causes no layout shift, and blocks the page only briefly', async ({
  page,
  openPage,
  server,
}) => {
  await openPage(LONG, { script: `${STYLE}${METER}` });
  const without = await costOf(page);
  await openPage(LONG, { script: `${STYLE}${METER}${MODULES}` });
  await page.waitForFunction(() => customElements.get('cartoon-smoke') && document.readyState === 'complete');
  // After the IntersectionObserver callback.
  await scrollPage(page, 0);
  const early = server.sent.map(({ file }) => file.split('/').at(-1)).filter((file) => /js|wasm/.test(file!));
  expect(new Set(early)).toEqual(new Set(['cartoonSmokeElement.js', 'element.js', 'errors.js']));
  const { shift, blocking } = await costOf(page);
  process.stdout.write(`embed.blockingMs: ${(blocking - without.blocking).toFixed(0)} ms added to an article\n`);
  expect(shift).toBe(0);
});
