import { expect, test } from '../support/fixtures.ts';

test.use({ deviceScaleFactor: 1 });

test('the page about the paper', async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await page.goto('/paper.html');
  await test.step('draws its figures, and says what is unknown', async () => {
    await expect(page.getByRole('status')).toHaveCount(0);
    await expect(page.locator('#figure-1 img')).toHaveCount(1);
    await expect(page.locator('#figure-3 canvas')).toHaveCount(4);
    await expect(page.locator('#figure-13 img')).toHaveCount(3);
    expect(await page.locator('dt').count()).toBeGreaterThan(6);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
  });
  await test.step('of the insets, each ramp leaves less smoke in full light than the one before', async () => {
    const [monochrome, twoTone, threeTone] = await page.locator('#figure-13 img').evaluateAll((images) =>
      images.map((image) => {
        const { naturalWidth: width, naturalHeight: height } = image as HTMLImageElement;
        const context = new OffscreenCanvas(width, height).getContext('2d')!;
        context.drawImage(image as HTMLImageElement, 0, 0);
        const pixels = new Uint32Array(context.getImageData(0, 0, width, height).data.buffer);
        const fullLight = 0xffe2eff6;
        return pixels.filter((pixel) => pixel === fullLight).length;
      }),
    );
    expect(threeTone).toBeGreaterThan(500);
    expect(twoTone).toBeGreaterThan(threeTone);
    expect(monochrome).toBeGreaterThan(twoTone);
  });
});
