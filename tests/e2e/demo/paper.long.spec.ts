import type { Page } from '@playwright/test';
import { expect, test } from '../../support/fixtures.ts';

test.use({ deviceScaleFactor: 1 });

/** Number of pictures in each of a figure's two columns. */
const PICTURES = { 'figure-1': 1, 'figure-2': 1, 'figure-3': 4, 'figure-13': 3 };

interface Measured {
  /** Number of colours, and share of the pixels with the most frequent one. */
  readonly colors: number;
  readonly commonest: number;
  /** Pixels of fully lit smoke. */
  readonly lit: number;
}

/** Measures each picture of the two columns, and the share of differing pixels of each pair. */
function measure(page: Page, figure: string) {
  return page.evaluate((id) => {
    const FULL_LIGHT = 0xffe2eff6;
    const [paper, ours] = ['paper', 'ours'].map((means) =>
      [...document.querySelectorAll(`#${id} .${means} :is(img, canvas)`)].map((picture) => {
        const isImage = picture instanceof HTMLImageElement;
        const { width, height } = isImage
          ? { width: picture.naturalWidth, height: picture.naturalHeight }
          : (picture as HTMLCanvasElement);
        const context = new OffscreenCanvas(width, height).getContext('2d')!;
        context.drawImage(picture as HTMLImageElement, 0, 0);
        return new Uint32Array(context.getImageData(0, 0, width, height).data.buffer);
      }),
    );
    const measured = [paper, ours].map((pictures) =>
      pictures.map((pixels): Measured => {
        const counts = new Map<number, number>();
        for (const pixel of pixels) counts.set(pixel, (counts.get(pixel) ?? 0) + 1);
        const commonest = Math.max(...counts.values()) / pixels.length;
        return { colors: counts.size, commonest, lit: counts.get(FULL_LIGHT) ?? 0 };
      }),
    );
    const differing = paper.map((pixels, index) => {
      const other = ours[index];
      return pixels.length === other.length
        ? pixels.filter((pixel, at) => pixel !== other[at]).length / pixels.length
        : 0;
    });
    return { paper: measured[0], ours: measured[1], differing };
  }, figure);
}

test('the page that compares with the paper', async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await page.goto('/paper.html');
  const picturesOf = (figure: string, means: string) => page.locator(`#${figure} .${means} :is(img, canvas)`);
  await test.step('draws its figures, and states what is unknown', async () => {
    await expect(page.getByRole('status')).toHaveCount(0);
    await expect(page.locator('figure')).toHaveCount(Object.keys(PICTURES).length);
    expect(await page.locator('dt').count()).toBeGreaterThan(6);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
  });
  for (const [figure, count] of Object.entries(PICTURES)) {
    await test.step(`${figure} has pictures by both methods, and they differ`, async () => {
      for (const means of ['paper', 'ours'] as const) await expect(picturesOf(figure, means)).toHaveCount(count);
      const measured = await measure(page, figure);
      for (const share of measured.differing) expect(share).toBeGreaterThan(0.02);
      // Colour and coverage are black and white, with greys along the edge.
      const least = figure === 'figure-3' ? 3 : 50;
      for (const { colors, commonest } of [...measured.paper, ...measured.ours]) {
        expect(colors).toBeGreaterThanOrEqual(least);
        expect(commonest).toBeLessThan(0.85);
      }
      const names = await page
        .locator(`#${figure}`)
        .getByRole('img')
        .evaluateAll((images) => images.map((image) => image.getAttribute('alt') ?? image.getAttribute('aria-label')));
      expect(names.filter(Boolean)).toHaveLength(2 * count);
      const links = await page
        .locator(`#${figure} .pair a`)
        .evaluateAll((all) => all.map((each) => each.getAttribute('href')));
      expect(links).toEqual([
        expect.stringMatching(/^\.\/\?t=.*puff\.form=billboards.*simulation\.integrator=paper/),
        expect.stringMatching(/^\.\/\?t=[\d.]+#v=\d+&preset=(?!.*(billboards|paper))/),
      ]);
    });
  }
  await test.step('of the insets, each ramp leaves less smoke in full light than the one before', async () => {
    const { paper, ours } = await measure(page, 'figure-13');
    for (const [monochrome, twoTone, threeTone] of [paper, ours]) {
      expect(threeTone.lit).toBeGreaterThan(500);
      expect(twoTone.lit).toBeGreaterThan(threeTone.lit);
      expect(monochrome.lit).toBeGreaterThan(twoTone.lit);
    }
  });
  await test.step('both methods are stacked on a phone, and side by side on a wide screen', async () => {
    const topsOf = () =>
      page.locator('#figure-1 img').evaluateAll((all) => all.map((each) => each.getBoundingClientRect().y));
    const [above, below] = await topsOf();
    expect(below).toBeGreaterThan(above + 100);
    await page.setViewportSize({ width: 1440, height: 900 });
    const [left, right] = await topsOf();
    expect(right).toBe(left);
  });
});
