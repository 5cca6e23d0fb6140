/** The page of the site with the effects of `puff()`. */
import { AxeBuilder } from '@axe-core/playwright';
import type { Page } from '@playwright/test';
import { EFFECTS } from '../../../src/page/puff/options.ts';
import { expect, longIf, test } from '../../support/fixtures.ts';

const code = (page: Page, effect: string) =>
  page
    .getByRole('listitem')
    .filter({ has: page.getByRole('button', { name: effect, exact: true }) })
    .locator('code');

for (const size of [
  { width: 1440, height: 900 },
  { width: 390, height: 844 },
]) {
  const tag = longIf(size.width > 390);
  test(`has a card for each effect, in a window of ${size.width} pixels${tag}`, async ({ page }) => {
    await page.setViewportSize(size);
    await page.goto('/puff.html');
    await expect(page.getByRole('listitem')).toHaveCount(EFFECTS.length);
    for (const effect of EFFECTS)
      await expect(code(page, effect)).toContainText(effect === 'poof' ? 'puff(button);' : effect);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(size.width);
    const clipped = await page
      .locator('li code')
      .evaluateAll((all) => all.filter((each) => each.scrollWidth > each.clientWidth));
    expect(clipped).toEqual([]);
    const { violations } = await new AxeBuilder({ page }).analyze();
    expect(violations.map(({ id }) => id)).toEqual([]);
  });
}

test('writes the options into the code, by keyboard, and copies it', async ({ page, context }) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await page.goto('/puff.html');
  await page.getByLabel('Size').focus();
  await page.keyboard.press('ArrowRight');
  await page.getByLabel('Look').selectOption('lamp-noir');
  const expected = "puff(button, { effect: 'boom', size: 1.05, preset: 'lamp-noir' });";
  await expect(code(page, 'boom')).toHaveText(expected);
  await page.getByRole('button', { name: 'Copy the code of boom' }).press('Enter');
  await expect(page.locator('#status')).toHaveText('Copied.');
  expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(expected);
  await page.getByRole('button', { name: 'Reset' }).click();
  await expect(code(page, 'boom')).toHaveText("puff(button, { effect: 'boom' });");
});

test('forms the text of the field, and writes it into the code of form only', async ({ page }) => {
  await page.goto('/puff.html');
  const field = page.getByLabel('Text', { exact: true });
  await field.fill(' TEA ');
  // Enter must not load the page again.
  await field.press('Enter');
  const expected = "puff(button, { effect: 'form', text: 'TEA' });";
  await expect(code(page, 'form')).toHaveText(expected);
  await expect(code(page, 'pop')).toHaveText("puff(button, { effect: 'pop' });");
  await page.getByRole('button', { name: 'form', exact: true }).click();
  await expect(page.locator('canvas')).toHaveCount(1);
  await expect(page.locator('#status')).toHaveText('');
  await field.fill('   ');
  await expect(code(page, 'form')).toHaveText("puff(button, { effect: 'form' });");
  await field.fill('TEA');
  await page.getByRole('button', { name: 'Reset' }).click();
  await expect(field).toHaveValue('');
  await expect(code(page, 'form')).toHaveText("puff(button, { effect: 'form' });");
});

test('shows smoke at the press of a button, and the error of a call', async ({ page }) => {
  await page.setViewportSize({ width: 400, height: 400 });
  await page.goto('/puff.html');
  await page.getByRole('button', { name: 'pop', exact: true }).press('Enter');
  await expect(page.locator('canvas')).toHaveCount(1);
  await page.getByRole('button', { name: 'Clear the smoke' }).click();
  await expect(page.locator('#status')).toHaveText('');
  await page.getByRole('button', { name: 'vanish', exact: true }).click();
  await expect(page.locator('.subject').first()).toHaveCSS('visibility', 'hidden');
});
