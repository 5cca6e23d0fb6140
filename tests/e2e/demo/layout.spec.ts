/** The picture is centred in the area without controls, and no control covers another one. */
import type { Locator, Page } from '@playwright/test';
import { expect, longIf, test } from '../../support/fixtures.ts';
import { LIGHT, open } from './page.ts';

test.use({ viewport: { width: 800, height: 620 } });

const edges = async (locator: Locator) => {
  const { x, width } = (await locator.boundingBox())!;
  return { left: x, right: x + width, middle: x + width / 2 };
};

/**
 * @param left, right edges of the visible area, CSS pixels; half the space between a panel and the smoke may be on
 *   either side
 */
async function expectMiddle(page: Page, left: number, right: number): Promise<void> {
  const away = async () => Math.abs((await edges(page.locator('#smoke'))).middle - (left + right) / 2);
  await expect.poll(away).toBeLessThan(8);
  const { left: first, right: last } = await edges(page.locator('#smoke'));
  expect([first <= 0, last >= 800]).toEqual([true, true]);
}

test('the picture is centred in the space beside the panels', async ({ page }) => {
  await open(page, `?paused=1${LIGHT}`);
  const gallery = page.locator('.gallery');
  const panel = page.getByRole('region', { name: 'Parameters' });
  const pressable = async () => {
    for (const button of await page.getByRole('group', { name: 'Playback' }).getByRole('button').all()) {
      await button.click({ trial: true });
    }
  };
  await test.step('gallery and panel', async () => {
    await expectMiddle(page, (await edges(gallery)).right, (await edges(panel)).left);
    await pressable();
  });
  await test.step('the panel alone', async () => {
    await page.keyboard.press('g');
    await expect(gallery).toBeHidden();
    await expectMiddle(page, 0, (await edges(panel)).left);
    await pressable();
  });
  await test.step('nothing', async () => {
    await page.getByRole('button', { name: 'Parameters', exact: true }).click();
    await expect(panel).toBeHidden();
    await expectMiddle(page, 0, 800);
  });
  await test.step('the gallery alone', async () => {
    await page.keyboard.press('g');
    await expectMiddle(page, (await edges(gallery)).right, 800);
    await pressable();
  });
});

test.describe('on a phone that rotates', () => {
  test.use({ viewport: { width: 390, height: 664 }, hasTouch: true, isMobile: true });

  test('the gallery closes in a low window, and reopens if it was open @long', async ({ page }) => {
    await open(page, `?paused=1${LIGHT}`);
    const gallery = page.locator('.gallery');
    const expectWidth = async (width: number) => {
      await expect.poll(() => page.locator('#smoke').evaluate(({ clientWidth }) => clientWidth)).toBe(width);
      // ResizeObserver callbacks run before the next frame.
      await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
    };
    const rotate = async (isOpen: boolean) => {
      await page.setViewportSize({ width: 664, height: 390 });
      await expectWidth(664);
      await expect(gallery).toBeHidden();
      await page.setViewportSize({ width: 390, height: 664 });
      await expectWidth(390);
      await expect(gallery).toBeVisible({ visible: isOpen });
    };
    await rotate(true);
    await page.getByRole('button', { name: 'Presets' }).tap();
    await expect(gallery).toBeHidden();
    await rotate(false);
  });

  test('a closed gallery stays closed when the window rotates and rotates back at once @long', async ({ page }) => {
    // The media query event arrives after the rotation is complete.
    await page.addInitScript(() => {
      const low = Object.assign(new EventTarget(), { matches: false });
      const { matchMedia } = window;
      window.matchMedia = (query) => (query.includes('max-height') ? (low as MediaQueryList) : matchMedia(query));
      Object.assign(window, { low });
    });
    await open(page, `?paused=1${LIGHT}`);
    const gallery = page.locator('.gallery');
    const notify = (matches: boolean) =>
      page.evaluate((is) => {
        const { low } = window as unknown as { low: MediaQueryList };
        Object.assign(low, { matches: is }).dispatchEvent(new Event('change'));
      }, matches);
    await notify(true);
    await expect(gallery).toBeHidden();
    await notify(false);
    await expect(gallery).toBeVisible();
    await page.getByRole('button', { name: 'Presets' }).tap();
    await expect(gallery).toBeHidden();
    await notify(false);
    await expect(gallery).toBeHidden();
  });
});

for (const [width, height] of [
  [390, 664],
  [320, 568],
]) {
  test.describe(`on a phone of ${width} x ${height}`, () => {
    test.use({ viewport: { width, height }, hasTouch: true, isMobile: true });

    test(`nothing covers the picture, and every button is visible${longIf(width > 320)}`, async ({ page }) => {
      await open(page, `?paused=1${LIGHT}`);
      const playback = page.getByRole('group', { name: 'Playback' });
      const presets = page.getByRole('button', { name: 'Presets' });
      const expectPictureAbove = async () => {
        const picture = (await page.locator('#smoke').boundingBox())!;
        const bar = (await playback.boundingBox())!;
        expect([picture.y, picture.y + picture.height <= bar.y, picture.height > height / 3]).toEqual([0, true, true]);
        expect(bar.y + bar.height).toBeLessThanOrEqual(height);
      };
      await test.step('with the gallery or without it', async () => {
        const isOpen = (await presets.getAttribute('aria-expanded')) === 'true';
        await expectPictureAbove();
        await presets.tap();
        await expect(presets).toHaveAttribute('aria-expanded', String(!isOpen));
        await expectPictureAbove();
      });
      await test.step('buttons are in rows within the window', async () => {
        for (const row of [playback, page.getByRole('banner')]) {
          // The button of the timeline is below the scrubber.
          const buttons = row.locator('button:visible:not(.timeline-button)');
          const boxes = await Promise.all((await buttons.all()).map((button) => button.boundingBox()));
          const middles = boxes.map((box) => Math.round(box!.y + box!.height / 2));
          expect(Math.max(...middles) - Math.min(...middles)).toBeLessThanOrEqual(1);
          expect(Math.max(...boxes.map((box) => box!.x + box!.width))).toBeLessThanOrEqual(width);
        }
      });
      await test.step('the picture alone fills the window', async () => {
        await open(page, `?paused=1&ui=0${LIGHT}`);
        expect(await page.locator('#smoke').boundingBox()).toEqual({ x: 0, y: 0, width, height });
      });
    });
  });
}
