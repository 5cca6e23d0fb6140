/** At the moment when a wipe changes the page, no pixel of the page is visible. */
import { PNG } from 'pngjs';
import type { Page } from '@playwright/test';
import { expect, longIf, test } from '../../../support/fixtures.ts';

type Cases = typeof import('./wipe.cases.ts');
const CASES = '/tests/visual/page/puff/wipe.cases.ts';

// The last one cannot fetch the code of wipes.
test.use({ ownPage: true, allowed: /ERR_FAILED/ });

interface Clip {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** Pixels of the page's own two colours in pictures of moments, and numbers of other colours. */
async function watch(page: Page, clip: Clip): Promise<Record<string, { page: number; colors: number; total: number }>> {
  const seen: Record<string, { page: number; colors: number; total: number }> = {};
  await page.exposeFunction('shoot', async (moment: string) => {
    const file = await page.screenshot({ clip });
    const { data, width, height } = PNG.sync.read(file);
    const pixels = Array.from({ length: width * height }, (_, at) => data.readUInt32BE(4 * at) >>> 8);
    const isPage = (color: number) => color === 0xff00ff || color === 0x00ff00;
    seen[moment] = {
      page: pixels.filter(isPage).length,
      colors: new Set(pixels).size,
      total: pixels.length,
    };
  });
  return seen;
}

const WIPES = [
  ['wide', [640, 360], {}],
  ['tall', [195, 422], { direction: 90, preset: 'lamp-noir' }],
  ['very wide', [800, 200], { direction: 200, color: 'tomato', duration: 0.5 }],
  ['large puffs', [320, 240], { direction: -45, preset: 'air-pow', seed: 5 }],
] as const;

for (const [name, [width, height], options] of WIPES) {
  for (const seed of [1, 2]) {
    test(`a wipe covers every pixel of a page: ${name}, seed ${seed}${longIf(name !== 'very wide' || seed > 1)}`, async ({
      load,
      blank,
    }) => {
      await blank.setViewportSize({ width, height });
      const seen = await watch(blank, { x: 0, y: 0, width, height });
      const cases = await load<Cases>(CASES);
      const report = await cases.evaluate((module, given) => module.wiped(given), { seed, ...options });
      expect(report).toEqual({ calls: 1, canvases: 0 });
      expect(seen.covered.page).toBe(0);
      expect(seen.covered.colors).toBeGreaterThan(2);
      expect(seen.after).toEqual({ page: width * height, colors: 1, total: width * height });
    });
  }
}

test('a wipe of an element covers it and nothing else', async ({ load, blank }) => {
  await blank.setViewportSize({ width: 400, height: 300 });
  const clip = { x: 50, y: 40, width: 200, height: 120 };
  const seen = await watch(blank, clip);
  const cases = await load<Cases>(CASES);
  const style = 'position: fixed; left: 50px; top: 40px; width: 200px; height: 120px';
  const report = await cases.evaluate((module, given) => module.wiped({ seed: 3 }, given), style);
  expect(report).toEqual({ calls: 1, canvases: 0 });
  expect(seen.covered.page).toBe(0);
  expect(seen.after.page).toBe(clip.width * clip.height);
});

for (const [how, outcome] of [
  ['escape', 'resolved'],
  ['clear', 'resolved'],
  ['hidden', 'resolved'],
  ['error of to', 'RangeError'],
  ['no code', 'LoadError'],
] as const) {
  test(`the page changes once: ${how}${longIf(how === 'error of to')}`, async ({ load, blank }) => {
    const cases = await load<Cases>(CASES);
    if (how === 'no code') await blank.route('**/puff/wipe.ts*', (route) => route.abort());
    expect(await cases.evaluate((module, given) => module.interrupted(given), how)).toEqual({
      outcome,
      calls: 1,
      canvases: 0,
    });
  });
}
