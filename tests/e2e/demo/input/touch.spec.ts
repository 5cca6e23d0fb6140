/** Touch input on a phone that replaces keys and the second mouse button. */
import type { Page } from '@playwright/test';
import { expect, test } from '../../../support/fixtures.ts';
import { ask, expectValue, LIGHT, open, row, valueOf } from '../page.ts';
import { fingerOf } from '../touch.ts';

test.use({ viewport: { width: 390, height: 600 }, hasTouch: true, isMobile: true });

const link = (page: Page) => page.evaluate(() => location.hash);
const openPanel = (page: Page) => page.getByRole('button', { name: 'Parameters', exact: true }).tap();

test('taps play, and a finger blows', async ({ page }) => {
  await open(page, `?paused=1${LIGHT}`);
  await test.step('taps step, play, pause, restart, slow down and open full screen', async () => {
    const bar = page.getByRole('group', { name: 'Playback' });
    const steps = () => ask(page, (stage) => stage.stats.steps);
    await bar.getByRole('button', { name: 'One step' }).tap();
    await expect.poll(steps).toBe(1);
    await bar.getByRole('button', { name: 'Play' }).tap();
    await expect.poll(steps).toBeGreaterThan(1);
    const isFull = () => page.evaluate(() => document.fullscreenElement !== null);
    await bar.getByRole('button', { name: 'Full screen' }).tap();
    await expect.poll(isFull).toBe(true);
    await bar.getByRole('button', { name: 'Pause' }).tap();
    await expect.poll(() => ask(page, (stage) => stage.playing)).toBe(false);
    await bar.getByRole('button', { name: 'Start over' }).tap();
    await expect.poll(steps).toBe(0);
    await bar.getByLabel('Speed').selectOption({ label: '½×' });
    expect(await ask(page, (stage) => stage.speed)).toBe(0.5);
    await bar.getByRole('button', { name: 'Full screen' }).tap();
    await expect.poll(isFull).toBe(false);
  });
  await test.step('a finger blows while the wind button is pressed, and orbits the camera otherwise', async () => {
    await ask(page, (stage) => stage.seek(1));
    const drag = await fingerOf(page);
    const [from, to] = [
      { x: 60, y: 120 },
      { x: 120, y: 100 },
    ];
    const wind = page.getByRole('button', { name: 'Blow into the smoke by dragging' });
    await wind.tap();
    await expect(wind).toHaveAttribute('aria-pressed', 'true');
    await drag(from, to);
    await expect.poll(() => ask(page, (stage) => stage.stats.inputs)).toBeGreaterThan(0);
    expect(await valueOf(page, 'camera.azimuth')).toBeUndefined();
    await wind.tap();
    await expect(wind).toHaveAttribute('aria-pressed', 'false');
    await drag(from, to);
    await expect.poll(() => valueOf(page, 'camera.azimuth')).not.toBeUndefined();
  });
});

test('a finger moves, chooses and resets in the panel', async ({ page }) => {
  await open(page, `?paused=1${LIGHT}`);
  await openPanel(page);
  await test.step('a finger moves a slider and a curve, undoes, redoes and resets', async () => {
    const drag = await fingerOf(page);
    const size = row(page, 'puff.size');
    await size.scrollIntoViewIfNeeded();
    const track = (await size.getByRole('slider').boundingBox())!;
    const middle = track.y + track.height / 2;
    await drag({ x: track.x + 0.64 * track.width, y: middle }, { x: track.x + track.width - 3, y: middle });
    await expectValue(page, 'puff.size', 4);
    await expect.poll(() => link(page)).toContain('puff.size=4');
    await page.getByRole('button', { name: 'Undo' }).tap();
    await expectValue(page, 'puff.size', 1);
    await page.getByRole('button', { name: 'Redo' }).tap();
    await expectValue(page, 'puff.size', 4);
    await size.getByRole('button', { name: 'Reset Puff size' }).tap();
    await expectValue(page, 'puff.size', 1);

    const density = row(page, 'emission.density');
    await density.locator('.curve-stop').last().scrollIntoViewIfNeeded();
    const before = await valueOf(page, 'emission.density');
    const stop = (await density.locator('.curve-stop').last().boundingBox())!;
    // Next to the stop, as an imprecise touch.
    const from = { x: stop.x - 4, y: stop.y + stop.height / 2 };
    await drag(from, { x: from.x, y: from.y - 40 });
    await expect.poll(() => valueOf(page, 'emission.density')).toMatch(/,1:\.\d+$/);
    expect(String(await valueOf(page, 'emission.density')).split(',')).toHaveLength(String(before).split(',').length);
    await page.getByRole('button', { name: 'Undo' }).tap();
    await expectValue(page, 'emission.density', before);
  });
  await test.step('the backdrop is chosen in the panel', async () => {
    await page.getByText('Debug views').tap();
    await page.getByLabel('View', { exact: true }).selectOption({ label: 'Depth' });
    expect(await ask(page, (stage) => stage.view)).toBe('depth');
    await expect(page.getByText('white is near, black is far')).toBeVisible();
    await page.keyboard.press('v');
    await expect(page.getByLabel('View', { exact: true })).toHaveValue('counts');
    const figures = page.getByRole('switch', { name: 'Statistics' });
    await figures.tap();
    await expect(page.getByRole('region', { name: 'Statistics' })).toContainText('alive');
    await page.keyboard.press('i');
    await expect(figures).not.toBeChecked();
  });
});
