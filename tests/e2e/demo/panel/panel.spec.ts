/** The search of the panel, and the panel as a bottom sheet on phones. */
import type { Locator, Page } from '@playwright/test';
import { expect, test } from '../../../support/fixtures.ts';
import { expectValue, LAMP, LIGHT, open } from '../page.ts';
import { fingerOf, middleOf, mouseOf, type Drag } from '../touch.ts';

const panelOf = (page: Page) => page.getByRole('region', { name: 'Parameters' });
const rowsOf = (page: Page) => panelOf(page).locator('.row').filter({ visible: true });
const keysOf = (rows: Locator) => rows.evaluateAll((all) => all.map((row) => (row as HTMLElement).dataset.key));

/** A search shows only matching rows and expands collapsed groups. Clearing it restores the panel. */
async function expectSearch(page: Page, enter: (words: string) => Promise<void>): Promise<void> {
  const field = page.getByRole('searchbox', { name: 'Find a parameter' });
  const before = await rowsOf(page).count();
  await enter('wind gust');
  await expect(field).toHaveValue('wind gust');
  expect(await keysOf(rowsOf(page))).toEqual(['wind.gusts', 'wind.gustTime']);
  await expect(panelOf(page).getByRole('status')).toHaveText('2 parameters');
  await enter('LUMPI');
  expect(await keysOf(rowsOf(page))).toEqual(['puff.lumpiness']);
  await page.getByLabel('Lumpiness, exact value').fill('0.1');
  await expectValue(page, 'puff.lumpiness', 0.1);
  await enter('no such thing');
  await expect(rowsOf(page)).toHaveCount(0);
  await expect(panelOf(page).getByRole('status')).toHaveText('0 parameters');
  await enter('');
  await expect(rowsOf(page)).toHaveCount(before);
}

test('the search of the panel', async ({ page }) => {
  await page.setViewportSize({ width: 760, height: 540 });
  await open(page, `?paused=1${LAMP}`);
  await page.keyboard.press('p');
  await expect(panelOf(page)).toBeHidden();
  await page.keyboard.press('/');
  const field = page.getByRole('searchbox', { name: 'Find a parameter' });
  await expect(field).toBeFocused();
  await test.step('the best matches come first, and an empty search restores the order', async () => {
    const order = () => keysOf(panelOf(page).locator('.row'));
    const before = await order();
    await field.fill('ink');
    expect((await keysOf(rowsOf(page)))[0]).toBe('style.inkColor');
    await field.fill('opacity');
    expect((await keysOf(rowsOf(page)))[0]).toBe('emission.density');
    await field.fill('colour');
    const british = await keysOf(rowsOf(page));
    await field.fill('color');
    expect(await keysOf(rowsOf(page))).toEqual(british);
    await field.fill('');
    expect((await order()).filter((key) => before.includes(key))).toEqual(before);
  });
  await test.step('no control is wider than the panel', async () => {
    const wide = rowsOf(page).evaluateAll((rows) => rows.filter((row) => row.scrollWidth > row.clientWidth).length);
    expect(await rowsOf(page).count()).toBeGreaterThan(40);
    expect(await wide).toBe(0);
  });
  await test.step('typed words find parameters, and an empty search shows all', async () => {
    await expectSearch(page, async (words) => {
      await field.press('Control+a');
      await field.press('Delete');
      await page.keyboard.type(words);
    });
  });
  await test.step('items are found in open and closed groups', async () => {
    await field.fill('circulation');
    expect(await keysOf(rowsOf(page))).toEqual(['vortices.0.circulation']);
    await field.fill('');
    await panelOf(page).locator('summary', { hasText: 'Emitter 1' }).click();
    await expect(panelOf(page).locator('[data-key="emitters.0.speed"]')).toBeVisible();
    await field.fill('wind gust');
    expect(await keysOf(rowsOf(page))).toEqual(['wind.gusts', 'wind.gustTime']);
    await expect(panelOf(page).getByRole('status')).toHaveText('2 parameters');
  });
});

test('knobs of billboards apply at the end of the gesture, and an unset colour shows its default', async ({ page }) => {
  await open(page, `?paused=1${LIGHT}&puff.form=billboards&style.ramp=0:2f5a34,.5:ffffff`);
  await page.keyboard.press('/');
  const slide = (event: string, place?: string) =>
    page.getByLabel('Lumpiness', { exact: true }).evaluate(
      (slider: HTMLInputElement, [type, value]) => {
        slider.value = value ?? slider.value;
        slider.dispatchEvent(new Event(type));
        return new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
      },
      [event, place] as const,
    );
  const exact = page.getByLabel('Lumpiness, exact value');
  await slide('input', '0');
  await expect(exact).toHaveValue('0');
  await expectValue(page, 'puff.lumpiness', 0.8);
  await slide('change');
  await expectValue(page, 'puff.lumpiness', 0);

  const shadow = page.getByLabel('Surface shadow', { exact: true });
  await expect(shadow).toHaveValue('#73ab7a');
  await shadow.fill('#203040');
  await expectValue(page, 'style.surfaceShadowColor', '#203040');
  await page.getByRole('button', { name: 'Reset Surface shadow' }).click();
  await expect(shadow).toHaveValue('#73ab7a');
  await expectValue(page, 'style.surfaceShadowColor', undefined);
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  /** Height of the sheet as a share of the window, after its animation. */
  const shareOf = async (page: Page) => {
    const panel = panelOf(page);
    await panel.evaluate((sheet) => Promise.all(sheet.getAnimations().map(({ finished }) => finished)));
    return Math.round((100 * (await panel.boundingBox())!.height) / 844);
  };

  async function openSheet(page: Page) {
    await page.getByRole('button', { name: 'Parameters', exact: true }).tap();
    await expect(panelOf(page)).toBeVisible();
    return page.getByRole('button', { name: 'Panel height' });
  }

  async function expectSheet(page: Page, drag: Drag) {
    const grip = await openSheet(page);
    const pull = async (pixels: number) => {
      const from = await middleOf(page, '.grip');
      await drag(from, { x: from.x, y: from.y + pixels });
    };
    await expect.poll(() => shareOf(page)).toBe(48);
    await pull(-80);
    await expect.poll(() => shareOf(page), 'let go near half, it rests there').toBe(48);
    await pull(-260);
    await expect.poll(() => shareOf(page)).toBe(88);
    await expect(grip).toHaveAttribute('aria-expanded', 'true');
    await pull(330);
    await expect.poll(() => shareOf(page)).toBe(48);
    const canvas = (await page.locator('canvas').boundingBox())!;
    const sheet = (await panelOf(page).boundingBox())!;
    expect(canvas.y + canvas.height, 'the smoke is in sight above').toBeLessThanOrEqual(sheet.y + 1);
    await pull(300);
    await expect(panelOf(page)).toBeHidden();
  }

  test('the sheet can be raised, lowered, closed and searched @long', async ({ page }) => {
    await open(page, `?paused=1${LIGHT}`);
    await test.step('a finger raises, lowers and closes the sheet', async () => {
      await expectSheet(page, await fingerOf(page));
    });
    await test.step('so does a mouse', async () => {
      await expectSheet(page, mouseOf(page));
    });
    await test.step('a tap and keys switch between the heights', async () => {
      const grip = await openSheet(page);
      await grip.tap();
      await expect.poll(() => shareOf(page)).toBe(88);
      const drag = await fingerOf(page);
      const from = await middleOf(page, '.grip');
      await drag(from, { x: from.x, y: from.y + 330 });
      await expect.poll(() => shareOf(page)).toBe(48);
      await grip.press('Enter');
      await expect.poll(() => shareOf(page)).toBe(88);
      await grip.press('ArrowDown');
      await expect.poll(() => shareOf(page)).toBe(48);
      await grip.press('ArrowDown');
      await expect(panelOf(page)).toBeHidden();
    });
    await test.step('the search works in the sheet', async () => {
      await openSheet(page);
      const field = page.getByRole('searchbox', { name: 'Find a parameter' });
      await field.tap();
      await expectSearch(page, (words) => field.fill(words));
    });
  });
});
