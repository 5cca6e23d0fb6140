/** The picture stands in the middle of what gallery and panel leave, and neither lies over what people press. */
import type { Locator, Page } from '@playwright/test';
import { expect, test } from '../support/fixtures.ts';
import { LIGHT, open } from './page.ts';

test.use({ viewport: { width: 800, height: 620 } });

const edges = async (locator: Locator) => {
  const { x, width } = (await locator.boundingBox())!;
  return { left: x, right: x + width, middle: x + width / 2 };
};

/** @param left, right of what shows, CSS pixels; half the space between a panel and the smoke may go to either */
async function expectMiddle(page: Page, left: number, right: number): Promise<void> {
  const away = async () => Math.abs((await edges(page.locator('#smoke'))).middle - (left + right) / 2);
  await expect.poll(away).toBeLessThan(8);
  const { left: first, right: last } = await edges(page.locator('#smoke'));
  expect([first <= 0, last >= 800]).toEqual([true, true]);
}

test('whatever is open beside it', async ({ page }) => {
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
