import type { Locator } from '@playwright/test';
import { expect, test } from '../support/fixtures.ts';

test.use({ deviceScaleFactor: 1 });

/** How many pictures each of a figure's two columns has. */
const PICTURES = { 'figure-1': 1, 'figure-2': 1, 'figure-3': 4, 'figure-13': 3 };

/** The pixels of each picture: images and canvases. */
function pixelsOf(pictures: Locator): Promise<number[][]> {
  return pictures.evaluateAll((elements) =>
    elements.map((element) => {
      const picture = element as HTMLImageElement | HTMLCanvasElement;
      const width = picture instanceof HTMLImageElement ? picture.naturalWidth : picture.width;
      const height = picture instanceof HTMLImageElement ? picture.naturalHeight : picture.height;
      const context = new OffscreenCanvas(width, height).getContext('2d')!;
      context.drawImage(picture, 0, 0);
      return [...new Uint32Array(context.getImageData(0, 0, width, height).data.buffer)];
    }),
  );
}

test('the page about the paper', async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await page.goto('/paper.html');
  const picturesOf = (figure: string, means: string) => page.locator(`#${figure} .${means} :is(img, canvas)`);
  await test.step('draws its figures, and says what is unknown', async () => {
    await expect(page.getByRole('status')).toHaveCount(0);
    await expect(page.locator('figure')).toHaveCount(Object.keys(PICTURES).length);
    expect(await page.locator('dt').count()).toBeGreaterThan(6);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
  });
  for (const [figure, count] of Object.entries(PICTURES)) {
    await test.step(`${figure} has its pictures by both means, and they differ`, async () => {
      const columns = [picturesOf(figure, 'paper'), picturesOf(figure, 'ours')];
      for (const column of columns) await expect(column).toHaveCount(count);
      const [paper, ours] = await Promise.all(columns.map(pixelsOf));
      paper.forEach((picture, index) => {
        expect(picture.length).toBe(ours[index].length);
        const differing = picture.filter((pixel, at) => pixel !== ours[index][at]).length;
        expect(differing / picture.length).toBeGreaterThan(0.02);
      });
      // Colour and coverage are black and white, with greys along the edge.
      const least = figure === 'figure-3' ? 3 : 50;
      for (const picture of [...paper, ...ours]) {
        const counts = new Map<number, number>();
        for (const pixel of picture) counts.set(pixel, (counts.get(pixel) ?? 0) + 1);
        expect(counts.size).toBeGreaterThanOrEqual(least);
        expect(Math.max(...counts.values()) / picture.length).toBeLessThan(0.85);
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
    for (const means of ['paper', 'ours']) {
      const fullLight = 0xffe2eff6;
      const pictures = await pixelsOf(picturesOf('figure-13', means));
      const [monochrome, twoTone, threeTone] = pictures.map(
        (pixels) => pixels.filter((pixel) => pixel === fullLight).length,
      );
      expect(threeTone).toBeGreaterThan(500);
      expect(twoTone).toBeGreaterThan(threeTone);
      expect(monochrome).toBeGreaterThan(twoTone);
    }
  });
  await test.step('both means stand one above the other on a phone, side by side where there is room', async () => {
    const topsOf = () =>
      page.locator('#figure-1 img').evaluateAll((all) => all.map((each) => each.getBoundingClientRect().y));
    const [above, below] = await topsOf();
    expect(below).toBeGreaterThan(above + 100);
    await page.setViewportSize({ width: 1440, height: 900 });
    const [left, right] = await topsOf();
    expect(right).toBe(left);
  });
});
