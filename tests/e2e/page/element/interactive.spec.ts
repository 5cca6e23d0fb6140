/** Pointer, touch and keyboard input of an interactive element, and what the page still receives. */
import type { Page } from '@playwright/test';
import type { CartoonSmokeElement } from '../../../../src/page/element/cartoonSmokeElement.ts';
import { expect, stands, test, WISP, type OpenPage } from '../../../support/embed.ts';
import { fingerOf, fingersOf } from '../../demo/touch.ts';

const BOX = 'position: absolute; left: 0; top: 0; width: 300px; height: 200px';

async function opened(page: Page, openPage: OpenPage, style = ''): Promise<void> {
  const tall = '<div style="height: 3000px"></div>';
  await openPage(`<cartoon-smoke ${WISP} paused interactive style="${BOX}"></cartoon-smoke>${tall}`, { style });
  await stands(page);
  // The pointer handlers are loaded lazily.
  await expect(page.locator('cartoon-smoke canvas')).toHaveAttribute('tabindex');
}

/** The camera's position: degrees around its target, and distance in metres; undefined before the first change. */
async function eye(page: Page): Promise<Record<'azimuth' | 'distance', number | undefined>> {
  const values = await page.locator('cartoon-smoke').evaluate((smoke: CartoonSmokeElement) => smoke.get());
  return { azimuth: values['camera.azimuth'], distance: values['camera.distance'] };
}

/** Distance of the camera from its target after a zoom, metres. */
async function distance(page: Page): Promise<number> {
  return (await eye(page)).distance ?? 0;
}

const scrolled = (page: Page) => page.evaluate(() => scrollY);

test('keys zoom, orbit, and reset the view', async ({ page, openPage }) => {
  await opened(page, openPage);
  await page.locator('cartoon-smoke canvas').focus();
  await page.keyboard.press('-');
  await expect.poll(() => distance(page)).toBeGreaterThan(0);
  const far = await distance(page);
  await page.keyboard.press('+');
  await expect.poll(() => distance(page)).toBeCloseTo(far / 1.15, 1);
  await page.keyboard.press('=');
  await expect.poll(() => distance(page)).toBeCloseTo(far / 1.15 ** 2, 1);
  const azimuth = async () => (await eye(page)).azimuth;
  await page.keyboard.press('ArrowRight');
  await expect.poll(azimuth).toBeDefined();
  const before = (await azimuth())!;
  await page.keyboard.press('ArrowRight');
  await expect.poll(azimuth).toBeCloseTo(before + 7.5, 1);
  await page.keyboard.press('0');
  await expect.poll(() => eye(page)).toEqual({ azimuth: undefined, distance: undefined });
});

test('the stage is told of a pointer that moves over the element', async ({ page, openPage }) => {
  await opened(page, openPage);
  await page.locator('cartoon-smoke').evaluate(async (smoke: CartoonSmokeElement) => {
    const stage = await smoke.stage;
    const pointer = async ({ type, x, y }: { type: string; x: number; y: number }) => {
      document.title = `${type} ${x} ${y}`;
      return null;
    };
    Object.assign(stage, { pointer });
  });
  await page.mouse.move(150, 100);
  await expect(page).toHaveTitle('move 150 100');
});

test('the wheel scrolls the page, and a pinch on a trackpad zooms', async ({ page, openPage }) => {
  await opened(page, openPage);
  await page.mouse.move(150, 100);
  await page.mouse.wheel(0, 50);
  await expect.poll(() => scrolled(page)).toBe(50);
  expect((await eye(page)).distance).toBeUndefined();
  await page.keyboard.down('Control');
  await page.mouse.wheel(0, 20);
  await expect.poll(() => distance(page)).toBeGreaterThan(0);
  const far = await distance(page);
  await page.mouse.wheel(0, -20);
  await expect.poll(() => distance(page)).toBeLessThan(0.9 * far);
  expect(await scrolled(page)).toBe(50);
});

test.describe('by touch', () => {
  test.use({ hasTouch: true });

  test('two fingers zoom', async ({ page, openPage }) => {
    await opened(page, openPage);
    const pinch = await fingersOf(page);
    await pinch([140, 160], [60, 240]);
    await expect.poll(() => distance(page)).toBeGreaterThan(0);
    const near = await distance(page);
    await pinch([60, 240], [120, 180]);
    await expect.poll(() => distance(page)).toBeCloseTo(near * 3, 1);
    expect(await scrolled(page)).toBe(0);
  });

  test('vertical swipes scroll the page, and horizontal swipes orbit the camera', async ({ page, openPage }) => {
    await opened(page, openPage);
    const swipe = await fingerOf(page);
    await swipe({ x: 200, y: 100 }, { x: 120, y: 100 });
    await expect.poll(async () => (await eye(page)).azimuth).toBeDefined();
    expect(await scrolled(page)).toBe(0);
    const { azimuth } = await eye(page);
    await swipe({ x: 150, y: 160 }, { x: 150, y: 60 });
    await expect.poll(() => scrolled(page)).toBeGreaterThan(50);
    expect((await eye(page)).azimuth).toBe(azimuth);
  });

  test('a page can give it all swipes @long', async ({ page, openPage }) => {
    await opened(page, openPage, 'cartoon-smoke::part(canvas) { touch-action: none }');
    const swipe = await fingerOf(page);
    await swipe({ x: 150, y: 160 }, { x: 150, y: 60 });
    await expect.poll(async () => (await eye(page)).azimuth).toBeDefined();
    expect(await scrolled(page)).toBe(0);
  });
});
