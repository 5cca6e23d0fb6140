/** A landing page with smoke over its first screen: the content below stays usable, and elements act as colliders. */
import { readFileSync } from 'node:fs';
import type { CartoonSmokeElement } from '../../../../src/page/element/cartoonSmokeElement.ts';
import { expect, MODULES, stands, test } from '../../../support/embed.ts';

const SOURCE = readFileSync(new URL('../../../../examples/landing/index.html', import.meta.url), 'utf8');
// Fewer particles and paused at the first step: these tests check the page.
const LANDING = /<body>([^]*)<\/body>/
  .exec(SOURCE)![1]
  .replaceAll(/\bstart="\d+"/g, '')
  .replaceAll('<cartoon-smoke', '<cartoon-smoke paused simulation-max-particles="300" puff-variations="1"');
const STYLE = '<link rel="stylesheet" href="/examples/landing/style.css" />';
const SHIFT = `<script>
  window.shift = 0;
  new PerformanceObserver((list) => list.getEntries().forEach(({ value }) => (window.shift += value)))
    .observe({ type: 'layout-shift', buffered: true });
</script>`;

for (const size of [
  { width: 1024, height: 700 },
  { width: 390, height: 844 },
]) {
  test(`smoke covers a landing page of ${size.width} pixels without blocking it`, async ({ page, openPage }) => {
    await page.setViewportSize(size);
    await openPage(LANDING, { script: `${STYLE}${SHIFT}${MODULES}` });
    await stands(page);
    const smoke = page.locator('cartoon-smoke').first();
    const values = await smoke.evaluate((element: CartoonSmokeElement) => element.get());
    const shapes = Object.keys(values).filter((key) => /^colliders\.\d\.shape$/.test(key));
    // Two lines, the text below them and the button.
    expect(shapes).toHaveLength(4);
    expect(values['emitters.0.shape']).toBe('box');
    await page.getByRole('link', { name: 'Choose a tea' }).click();
    await expect.poll(() => page.evaluate(() => location.hash)).toBe('#teas');
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    expect(wide).toBe(size.width);
    expect(await page.evaluate(() => Reflect.get(window, 'shift') as number)).toBe(0);
  });
}
