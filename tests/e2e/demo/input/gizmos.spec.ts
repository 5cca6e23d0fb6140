import type { Page } from '@playwright/test';
import { expect, test } from '../../../support/fixtures.ts';
import { ask, expectSteps, LAMP, open } from '../page.ts';
import { fingerOf, middleOf, mouseOf, type Drag } from '../touch.ts';

const handle = (key: string) => `[data-gizmo="${key}"]`;
const numberOf = (page: Page, key: string) =>
  page.evaluate((name) => {
    const stage = window.cartoonSmoke!;
    return Number({ ...stage.rig, ...stage.get() }[name] ?? 0);
  }, key);
const link = (page: Page) => page.evaluate(() => decodeURIComponent(location.hash));
/** The same number in the link. */
const linkedNumber = async (page: Page, key: string) =>
  Number(new URLSearchParams((await link(page)).slice(1)).get(key));
/** A few pixels of the picture, enough to detect changes. */
const pictureOf = (page: Page) =>
  ask(page, async (stage) => {
    const bytes = new Uint8Array(await (await stage.picture()).arrayBuffer());
    return bytes.reduce((sum, byte, index) => (sum * 31 + byte + index) % 2147483647, 7);
  });

/** Drags a handle and checks value, picture, link and undo. */
async function expectGesture(page: Page, drag: Drag, key: string, value: string, by: { x: number; y: number }) {
  // The other handles only affect new smoke.
  const showsAtOnce = key === 'light';
  const before = { number: await numberOf(page, value), picture: showsAtOnce && (await pictureOf(page)) };
  const from = await middleOf(page, handle(key));
  const to = { x: from.x + by.x, y: from.y + by.y };
  await drag(from, to);
  await expect.poll(() => numberOf(page, value), { message: `${key} moves ${value}` }).not.toBe(before.number);
  // The stage applies edits with its next frame; its current value may be from the middle of the gesture.
  await expect
    .poll(async () => (await linkedNumber(page, value)) - (await numberOf(page, value)), { message: 'link' })
    .toBe(0);
  const after = await numberOf(page, value);
  const moved = await middleOf(page, handle(key));
  expect(Math.hypot(moved.x - to.x, moved.y - to.y), `the handle of ${key} is where it was let go`).toBeLessThan(4);
  if (showsAtOnce) expect(await pictureOf(page), 'picture').not.toBe(before.picture);
  await page.keyboard.press('Control+z');
  await expect.poll(() => numberOf(page, value), { message: 'undone' }).toBe(before.number);
  await page.keyboard.press('Control+Shift+z');
  await expect.poll(() => numberOf(page, value), { message: 'done again' }).toBe(after);
}

async function expectAllGestures(page: Page, drag: Drag) {
  await expectGesture(page, drag, 'light', 'light.azimuth', { x: -60, y: 12 });
  await expectGesture(page, drag, 'wind', 'forces.wind.x', { x: 50, y: -10 });
  await expectGesture(page, drag, 'emitters.0', 'emitters.0.position.x', { x: -30, y: -24 });
  await page.getByRole('button', { name: 'Add a vortex' }).click();
  await expect.poll(() => numberOf(page, 'vortices.1.circulation')).not.toBe(0);
  await expectGesture(page, drag, 'vortices.1', 'vortices.1.position.y', { x: 20, y: -30 });
}

test('handles of sun, wind, emitter and vortex follow the mouse and the keys', async ({ page }) => {
  await page.setViewportSize({ width: 690, height: 480 });
  await open(page, `?paused=1${LAMP}`);
  await expect(page.locator('.gizmo').filter({ visible: true })).toHaveCount(0);
  await page.keyboard.press('h');
  await expectAllGestures(page, mouseOf(page));

  for (const [key, value, press] of [
    ['light', 'light.elevation', 'ArrowUp'],
    ['wind', 'forces.wind.y', 'ArrowUp'],
    ['emitters.0', 'emitters.0.position.z', 'PageDown'],
    ['vortices.1', 'vortices.1.position.x', 'ArrowLeft'],
  ]) {
    const before = await numberOf(page, value);
    await page.locator(handle(key)).press(press);
    await expect.poll(() => numberOf(page, value), { message: `${press} moves ${value}` }).not.toBe(before);
  }

  // When attached it keeps its position, and then moves with the ball.
  const place = await middleOf(page, handle('vortices.1'));
  await page.getByLabel('Attach Vortex 2 to').selectOption({ label: 'Ball' });
  await expect.poll(() => link(page)).toContain('vortices.1.rigid=0');
  const attached = await middleOf(page, handle('vortices.1'));
  expect(Math.hypot(attached.x - place.x, attached.y - place.y)).toBeLessThan(3);
  await ask(page, (stage) => {
    stage.nudge({ dx: -0.5 });
    stage.step(30);
  });
  await expect.poll(async () => (await middleOf(page, handle('vortices.1'))).x).toBeLessThan(place.x - 20);
  await page.keyboard.press('h');
  await expect(page.locator('.gizmo').filter({ visible: true })).toHaveCount(0);
});

test('a vortex is attached to the propeller, follows it with its handle, and is detached @long', async ({ page }) => {
  await page.setViewportSize({ width: 690, height: 480 });
  const smoke = '#v=1&preset=airplane&emission.rate=20&puff.variations=1&simulation.maxParticles=300';
  await open(page, `?paused=1&t=1${smoke}&vortices.0.circulation=2&vortices.0.position.y=0.7`);
  await expectSteps(page, 60);
  await page.keyboard.press('p');
  await page.locator('summary', { hasText: 'Vortex 1' }).click();
  const choice = page.getByLabel('Attached to', { exact: true }).filter({ visible: true });
  await expect(choice.locator('option')).toHaveText(['Nothing', 'Airplane', 'Propeller', 'Scarf']);
  await choice.selectOption('Propeller');
  await expect.poll(() => link(page)).toContain('vortices.0.rigid=4096');
  await page.keyboard.press('p');
  await page.keyboard.press('h');
  /** Distance on screen between the vortex, computed from the geometry of the airplane, and its handle. */
  const distance = async () => {
    const expected = await ask(page, (stage) => {
      // 0.7 m from the hub on a blade with 3.2 revolutions per second, in the airplane's space.
      const angle = 2 * Math.PI * 3.2;
      const seen = stage.sight.project([0.98, 0.02 + 0.7 * Math.cos(angle), 0.7 * Math.sin(angle)], 0)!;
      const { left, top } = (stage.canvas as HTMLCanvasElement).getBoundingClientRect();
      return { x: left + seen.x, y: top + seen.y };
    });
    const { x, y } = await middleOf(page, handle('vortices.0'));
    return Math.hypot(x - expected.x, y - expected.y);
  };
  await expect.poll(distance).toBeLessThan(2);
  await page.locator(handle('vortices.0')).focus();
  await page.getByLabel('Attach Vortex 1 to').selectOption('Nothing');
  await expect.poll(() => link(page)).toContain('vortices.0.rigid=-1');
  await expect.poll(distance).toBeLessThan(2);
  expect(await linkedNumber(page, 'vortices.0.position.x')).toBeGreaterThan(0.9);
});

test.describe('by touch', () => {
  test.use({ viewport: { width: 390, height: 600 }, hasTouch: true, isMobile: true });

  test('handles follow a finger @long', async ({ page }) => {
    await open(page, `?paused=1${LAMP}`);
    await page.getByRole('button', { name: 'Handles' }).tap();
    await expectAllGestures(page, await fingerOf(page));
  });
});
