/** The dial of the hour in the panel. */
import type { Page } from '@playwright/test';
import { decode, presetValues, type Values } from '../../../../src/preset.ts';
import { expect, test } from '../../../support/fixtures.ts';
import { ask, expectValue, LIGHT, open, row } from '../page.ts';

const KEYS = [
  'light.azimuth',
  'light.elevation',
  'light.color',
  'light.intensity',
  'light.ambientColor',
  'light.ambient',
  'style.inkLight',
  'style.backdrop',
] as const;

const dialOf = (page: Page) => page.getByRole('slider', { name: 'Time of day' });
const lightIn = (values: Values) => KEYS.map((key) => values[key]);
const lightOf = async (page: Page) => lightIn(await ask(page, (stage) => stage.get()));

/** Waits until the dial shows an hour, and the stage the light of it. @returns the light */
async function expectHour(page: Page, text: string | RegExp, light?: readonly unknown[]): Promise<readonly unknown[]> {
  await expect(dialOf(page)).toHaveAttribute('aria-valuetext', text);
  if (light) await expect.poll(() => lightOf(page)).toEqual(light);
  // The stage gets the edits with the next frame.
  await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
  return lightOf(page);
}

/** Waits until the link in the address bar has a light. Links of earlier moments of a gesture have another one. */
async function expectLink(page: Page, light: readonly unknown[]): Promise<void> {
  await expect.poll(async () => lightIn((await decode(new URL(page.url()).hash)).state.values)).toEqual(light);
}

const OWN = lightIn(presetValues('air'));

test('the dial moves light and backdrop as one change, by keys and by pointer', async ({ page }) => {
  await page.setViewportSize({ width: 760, height: 540 });
  await open(page, `?paused=1${LIGHT}`);
  const dial = dialOf(page);
  await expectHour(page, '14:00, own light', OWN);

  await test.step('a held arrow key is one change of all values', async () => {
    await dial.focus();
    for (let press = 0; press < 24; ++press) await page.keyboard.down('ArrowRight');
    await page.keyboard.up('ArrowRight');
    const dusk = await expectHour(page, '20:00, dusk');
    for (const [index, key] of KEYS.entries()) expect(dusk[index], key).not.toBe(OWN[index]);
    await page.keyboard.press('Control+z');
    await expectHour(page, '14:00, own light', OWN);
    await page.keyboard.press('Control+Shift+z');
    await expectHour(page, '20:00, dusk', dusk);
  });
  await test.step('ends, hours and midnight', async () => {
    await page.keyboard.press('Home');
    const midnight = await expectHour(page, '00:00, night');
    await page.keyboard.press('ArrowLeft');
    await expectHour(page, '23:45, night');
    await page.keyboard.press('ArrowRight');
    await expectHour(page, '00:00, night', midnight);
    await page.keyboard.press('End');
    await expectHour(page, '23:45, night');
    await page.keyboard.press('Shift+ArrowLeft');
    await expectHour(page, '22:45, night');
  });
  await test.step('the reset button restores the light of the preset', async () => {
    await page.getByRole('button', { name: 'Reset Time of day' }).click();
    await expectHour(page, '14:00, own light', OWN);
    await expect(page.getByRole('button', { name: 'Reset Time of day' })).toHaveCount(0);
  });
  await test.step('a drag is one change, which the link has', async () => {
    await dial.scrollIntoViewIfNeeded();
    const { x, y, width, height } = (await dial.boundingBox())!;
    await page.mouse.move(x + 0.59 * width, y + height / 2);
    await page.mouse.down();
    await page.mouse.move(x + 0.7 * width, y + height / 2);
    await page.mouse.move(x + 0.78 * width, y + height / 2);
    await page.mouse.up();
    const light = await expectHour(page, /^1[89]:\d\d, dusk$/);
    await expectLink(page, light);
    const shown = (await dial.getAttribute('aria-valuetext'))!;
    await page.keyboard.press('Control+z');
    await expectHour(page, '14:00, own light', OWN);
    await page.keyboard.press('Control+Shift+z');
    await expectHour(page, shown, light);
    await expectLink(page, light);
    await page.reload();
    await expectHour(page, shown, light);
  });
});

test('the dial has no hour for a light that is not on its path, and one undo restores that light', async ({ page }) => {
  await page.setViewportSize({ width: 760, height: 540 });
  await open(page, `?paused=1${LIGHT}&light.elevation=33&light.color=ff0000`);
  const before = await expectHour(page, 'own light');
  await dialOf(page).press('End');
  await expectHour(page, '23:45, night');
  await page.keyboard.press('Control+z');
  await expectHour(page, 'own light', before);
  for (const key of ['light.elevation', 'light.color']) await row(page, key).getByRole('button').click();
  await expectHour(page, '14:00, own light', OWN);
});

test('the dial darkens a look whose fire glows, relative to the look by day @long', async ({ page }) => {
  await page.setViewportSize({ width: 760, height: 540 });
  await open(page, '?paused=1#v=1&preset=campfire-night');
  await expectHour(page, 'own light', lightIn(presetValues('campfire-night')));
  await dialOf(page).press('Home');
  await expectHour(page, '00:00, night');
  const night = await ask(page, (stage) => stage.get());
  const day = presetValues('campfire');
  for (const key of ['light.intensity', 'light.ambient'] as const)
    expect(night[key], key).toBeLessThan(0.85 * day[key]!);
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test('a tap on the dial sets the hour', async ({ page }) => {
    await open(page, `?paused=1${LIGHT}`);
    await page.getByRole('button', { name: 'Parameters', exact: true }).tap();
    const dial = dialOf(page);
    await dial.scrollIntoViewIfNeeded();
    const { x, y, width, height } = (await dial.boundingBox())!;
    expect(height).toBeGreaterThanOrEqual(24);
    await page.touchscreen.tap(x + 0.96 * width, y + height / 2);
    await expect(dial).toHaveAttribute('aria-valuetext', /^2[23]:\d\d, night$/);
    await expectValue(page, 'light.color', '#8ca8ff');
  });
});
