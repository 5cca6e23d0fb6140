import { AxeBuilder } from '@axe-core/playwright';
import type { Locator, Page } from '@playwright/test';
import { expect, test } from '../../support/fixtures.ts';
import { closeSheet, LIGHT, open } from './page.ts';

/** The violations that axe finds: the rule and the element. */
async function expectNoFaults(page: Page, view: string): Promise<void> {
  // Skip the locations of passed rules, which take most of the time, and the search in frames.
  const axe = new AxeBuilder({ page }).options({ resultTypes: ['violations'] }).setLegacyMode();
  const { violations } = await axe.analyze();
  const faults = violations.flatMap(({ id, nodes }) => nodes.map(({ target }) => `${id}: ${String(target)}`));
  expect(faults, view).toEqual([]);
}

test('axe finds nothing on the page, its sheets, its panel and its handles', async ({ page }) => {
  await page.setViewportSize({ width: 800, height: 610 });
  await open(page, `?paused=1&stats=1${LIGHT}&bogus=1`);
  await expectNoFaults(page, 'panel, gallery, statistics and a message');
  await page.keyboard.press('?');
  await expectNoFaults(page, 'help');
  await closeSheet(page);
  await page.keyboard.press('s');
  const shared = page.getByRole('dialog', { name: 'Share this smoke' });
  await expect(shared.getByRole('img', { name: 'QR code of the link' })).toBeVisible();
  await shared.getByText('Embed in your page').click();
  await expectNoFaults(page, 'share');
  await closeSheet(page);
  await page.keyboard.press('c');
  const captures = page.getByRole('dialog', { name: 'Capture the smoke' });
  await captures.getByLabel('Format').selectOption('zip');
  await expectNoFaults(page, 'capture');
  await closeSheet(page);
  await page.evaluate(() => document.querySelectorAll('details').forEach((group) => (group.open = true)));
  await page.keyboard.press('h');
  await page.getByRole('button', { name: 'Add a vortex' }).click();
  await expectNoFaults(page, 'the other groups and the handles');
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test('axe finds nothing, with the sheet and without @long', async ({ page }) => {
    await open(page, `?paused=1${LIGHT}`);
    await expectNoFaults(page, 'page');
    await page.getByRole('button', { name: 'Parameters', exact: true }).tap();
    await expect(page.getByRole('region', { name: 'Parameters' })).toBeVisible();
    await expectNoFaults(page, 'sheet');
    await page.getByRole('button', { name: 'Close the parameters' }).tap();
    await page.getByRole('button', { name: 'Capture' }).tap();
    await expect(page.getByRole('dialog', { name: 'Capture the smoke' })).toBeVisible();
    await expectNoFaults(page, 'capture');
  });
});

test.describe('with reduced motion, at 200 %', () => {
  // The CSS pixels of a 1280 x 720 window at 200 % zoom.
  test.use({ viewport: { width: 640, height: 360 }, contextOptions: { reducedMotion: 'reduce' } });

  test('axe finds nothing beside the still frame, and everything is reachable', async ({ page }) => {
    await open(page, LIGHT);
    await expect(page.getByRole('button', { name: 'Play the smoke' })).toBeVisible();
    await expectNoFaults(page, 'still picture');
    const outside = await page.evaluate(() =>
      [...document.querySelectorAll('header button, .transport button, .transport select')]
        .filter((element) => element.checkVisibility())
        .map((element) => ({ name: element.getAttribute('aria-label'), box: element.getBoundingClientRect() }))
        .filter(({ box }) => box.left < 0 || box.top < 0 || box.right > innerWidth || box.bottom > innerHeight)
        .map(({ name }) => name),
    );
    expect(outside).toEqual([]);
  });
});

test.describe('in forced colours', () => {
  test.use({ viewport: { width: 800, height: 620 }, contextOptions: { forcedColors: 'active' } });

  test('toggles show their state, and sliders have a track', async ({ page }) => {
    await open(page, `?paused=1${LIGHT}`);
    const background = (on: Locator) => on.evaluate((element) => getComputedStyle(element).backgroundColor);
    const handles = page.getByRole('button', { name: 'Handles' });
    const off = await background(handles);
    await handles.press('Enter');
    await expect(handles).toHaveAttribute('aria-pressed', 'true');
    await expect.poll(() => background(handles)).not.toBe(off);
    const cards = page.locator('.gallery-card');
    const chosen = page.locator('.gallery-card:has(:checked)');
    await expect.poll(() => background(chosen)).not.toBe(await background(cards.last()));
    const line = page.getByRole('slider').first();
    expect(await line.evaluate((element) => getComputedStyle(element).backgroundImage)).toContain('gradient');
    await page.keyboard.press('s');
    const kinds = page.locator('.share-what label');
    await expect(kinds.first()).toBeVisible();
    expect(await background(kinds.first())).not.toBe(await background(kinds.last()));
  });
});

test('axe finds nothing on the page about the paper, which draws its puffs @long', async ({ page }) => {
  await page.goto('/paper.html');
  await expect(page.getByRole('heading', { level: 1 })).toBeVisible();
  await expectNoFaults(page, 'paper');
  for (const means of ['paper', 'ours']) await expect(page.locator(`#figure-3 .${means} canvas`)).toHaveCount(4);
});
