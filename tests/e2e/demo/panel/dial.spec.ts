/** The dial of the hour in the panel. */
import type { Page } from '@playwright/test';
import { daylight, DAYLIGHT_KEYS } from '../../../../src/demo/panel/daylight.ts';
import { presetValues, type Values } from '../../../../src/preset.ts';
import { expect, test } from '../../../support/fixtures.ts';
import { ask, expectValue, LIGHT, open, row, valueOf } from '../page.ts';

const BACKDROP = '0:f6e2c6,1:9ac4d6';
const at = (hour: number): Values => daylight(hour, presetValues('air'), BACKDROP) as Values;
const dialOf = (page: Page) => page.getByRole('slider', { name: 'Time of day' });

async function expectHour(page: Page, text: string, values: Values): Promise<void> {
  await expect(dialOf(page)).toHaveAttribute('aria-valuetext', text);
  for (const key of DAYLIGHT_KEYS) await expectValue(page, key, values[key]);
}

test('the dial moves light and backdrop as one change, by keys and by pointer', async ({ page }) => {
  await open(page, `?paused=1${LIGHT}`);
  const dial = dialOf(page);
  await expectHour(page, '14:00, own light', at(14));
  expect((await ask(page, ({ rig }) => rig))['style.backdrop']).toBe(BACKDROP);

  await test.step('a held arrow key is one change', async () => {
    await dial.focus();
    for (let press = 0; press < 3; ++press) await page.keyboard.down('ArrowRight');
    await page.keyboard.up('ArrowRight');
    await expectHour(page, '14:45, day', at(14.75));
    await page.keyboard.press('Control+z');
    await expectHour(page, '14:00, own light', at(14));
  });
  await test.step('ends, hours and midnight', async () => {
    await page.keyboard.press('Home');
    await expectHour(page, '00:00, night', at(0));
    await page.keyboard.press('ArrowLeft');
    await expectHour(page, '23:45, night', at(23.75));
    await page.keyboard.press('Home');
    await page.keyboard.press('End');
    await expectHour(page, '23:45, night', at(23.75));
    await page.keyboard.press('Shift+ArrowLeft');
    await expectHour(page, '22:45, night', at(22.75));
  });
  await test.step('the reset button restores the light of the preset', async () => {
    await page.getByRole('button', { name: 'Reset Time of day' }).click();
    await expectHour(page, '14:00, own light', at(14));
    await expect(page.getByRole('button', { name: 'Reset Time of day' })).toHaveCount(0);
  });
  await test.step('a drag is one change, which the link has', async () => {
    await dial.scrollIntoViewIfNeeded();
    const { x, y, width, height } = (await dial.boundingBox())!;
    await page.mouse.move(x + width / 2, y + height / 2);
    await page.mouse.down();
    await page.mouse.move(x + 0.6 * width, y + height / 2);
    await page.mouse.move(x + 0.78 * width, y + height / 2);
    await page.mouse.up();
    await expect(dial).toHaveAttribute('aria-valuetext', /^18:\d\d, dusk$/);
    const hour = Number(await dial.inputValue());
    await expectHour(page, (await dial.getAttribute('aria-valuetext'))!, at(hour));
    await expect.poll(() => page.evaluate(() => location.hash)).toContain('style.backdrop=');
    await page.reload();
    await expectHour(page, (await dial.getAttribute('aria-valuetext'))!, at(hour));
    expect(Number(await dial.inputValue())).toBe(hour);
    await page.goBack();
  });
});

test('the dial has no hour for a light that is not on its path, and one undo restores that light', async ({ page }) => {
  await open(page, `?paused=1${LIGHT}&light.elevation=33&light.color=ff0000`);
  await expect(dialOf(page)).toHaveAttribute('aria-valuetext', 'own light');
  const before = await ask(page, (stage) => stage.get());
  await dialOf(page).press('End');
  await expectHour(page, '23:45, night', at(23.75));
  await page.keyboard.press('Control+z');
  await expectHour(page, 'own light', before);
  await row(page, 'light.elevation').getByRole('button').click();
  await row(page, 'light.color').getByRole('button').click();
  await expect(dialOf(page)).toHaveAttribute('aria-valuetext', '14:00, own light');
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
    await page.touchscreen.tap(x + 0.9 * width, y + height / 2);
    await expect(dial).toHaveAttribute('aria-valuetext', /^2[12]:\d\d, night$/);
    expect(await valueOf(page, 'light.intensity')).toBeLessThan(0.7);
  });
});
