import type { Page } from '@playwright/test';
import { expect, test } from '../../../support/fixtures.ts';
import { expectValue, LIGHT, open, row, valueOf } from '../page.ts';

const KEY = 'style.ramp';

/** A position on the colour bar, 0 to 1 along it, in CSS pixels. */
async function onBar(page: Page, along: number): Promise<{ x: number; y: number }> {
  const box = (await row(page, KEY).locator('.ramp-bar').boundingBox())!;
  return { x: box.x + along * box.width, y: box.y + box.height / 3 };
}

/** A click waits until the bar no longer moves. */
async function pressBar(page: Page, along: number): Promise<void> {
  const bar = row(page, KEY).locator('.ramp-bar');
  const { width, height } = (await bar.boundingBox())!;
  await bar.click({ position: { x: along * width, y: height / 3 } });
}

/** Positions of the stops of the stage's ramp. */
async function places(page: Page): Promise<number[]> {
  const text = String(await valueOf(page, KEY));
  return text === '' ? [] : text.split(',').map((stop) => Number(stop.split(':')[0]));
}

test('stops of a ramp are added, dragged, coloured, moved by keys, undone and removed', async ({ page }) => {
  await open(page, `?paused=1${LIGHT}`);
  await page.keyboard.press('p');
  const control = row(page, KEY);
  const stops = control.locator('.ramp-stop');
  await control.scrollIntoViewIfNeeded();
  await expect(control.getByRole('button', { name: 'Remove this stop' })).toBeHidden();

  await pressBar(page, 0.2);
  await expectValue(page, KEY, '0:6a6a8c,.5:ffffff');
  await pressBar(page, 0.75);
  await expect(stops).toHaveCount(3);
  await expect.poll(async () => (await places(page))[2]).toBeCloseTo(0.75, 1);

  await stops.nth(2).hover();
  await page.mouse.down();
  const to = await onBar(page, 0.9);
  await page.mouse.move(to.x - 5, to.y);
  await page.mouse.move(to.x, to.y);
  await page.mouse.up();
  await expect.poll(async () => (await places(page))[2]).toBeCloseTo(0.9, 1);
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect.poll(async () => (await places(page))[2]).toBeCloseTo(0.75, 1);

  await stops.nth(1).focus();
  await page.keyboard.press('ArrowLeft');
  await expect.poll(async () => (await places(page))[1]).toBe(0.48);
  await control.getByLabel('Colour of the chosen stop').fill('#ff8800');
  await expect.poll(() => valueOf(page, KEY)).toContain('.48:ff8800');
  await expect.poll(() => page.evaluate(() => location.hash)).toContain('style.ramp=0:6a6a8c,.48:ff8800');

  await stops.nth(1).focus();
  await page.keyboard.press('Delete');
  await expect(stops).toHaveCount(2);
  await control.getByRole('button', { name: 'Remove this stop' }).click();
  await expectValue(page, KEY, '');
  await expect(stops).toHaveCount(0);
});

test('a link with a malformed ramp shows the tones of the preset, with a message', async ({ page }) => {
  await open(page, `?paused=1${LIGHT}&style.ramp=0:red,1:blue`);
  await expect(page.getByText('style.ramp cannot be')).toContainText('2 to 16 stops');
  await expectValue(page, KEY, '');
});
