import type { Page } from '@playwright/test';
import { expect, test } from '../../support/fixtures.ts';
import { ask, crawl, LAMP, LIGHT, open } from './page.ts';
import { fingerOf, mouseOf, type Drag } from './touch.ts';

const stepsOf = (page: Page) => ask(page, (stage) => stage.stats.steps);
const line = (page: Page) => page.getByRole('slider', { name: 'Timeline' });

/** Drags the knob from one time to another, seconds. */
async function scrub(page: Page, drag: Drag, from: number, to: number): Promise<void> {
  const box = (await line(page).boundingBox())!;
  const most = Number(await line(page).getAttribute('max'));
  // The knob's centre stays half its width inside the line.
  const place = (seconds: number) => ({
    x: box.x + 8 + ((box.width - 16) * seconds) / most,
    y: box.y + box.height / 2,
  });
  await drag(place(from), place(to));
}

interface KnobState {
  steps: number;
  hash: string;
}

/** Waits until the smoke has reached the knob's time, within some steps; then no seek is running any more. */
async function arrival(page: Page, isThere: (steps: number) => boolean): Promise<KnobState> {
  const look = () =>
    ask(page, (stage) => {
      const wanted = document.querySelector<HTMLInputElement>('input.timeline')!.valueAsNumber;
      const { steps } = stage.stats;
      return { steps, hash: stage.hash(), isAtKnob: Math.abs(steps / 60 - wanted) < 1e-6 };
    });
  await expect.poll(() => look().then(({ steps, isAtKnob }) => isAtKnob && isThere(steps)), 'the knob').toBe(true);
  return look();
}

/** Forward, back and forward again: the same moment has the same smoke. */
async function expectScrubbing(page: Page, drag: Drag): Promise<void> {
  await scrub(page, drag, 0, 2);
  const { steps, hash } = await arrival(page, (count) => count > 90);
  await scrub(page, drag, steps / 60, 0.5);
  await arrival(page, (count) => count < 60);
  await ask(page, (stage) => stage.seek(0));
  await page.evaluate((seconds) => window.cartoonSmoke!.seek(seconds), steps / 60);
  expect(await ask(page, (stage) => stage.hash())).toBe(hash);
}

test('mouse and keys use the timeline and the presets', async ({ page }) => {
  await open(page, `?paused=1${LAMP}`);
  await test.step('the timeline seeks forwards and backwards by mouse and keys', async () => {
    await expectScrubbing(page, mouseOf(page));
    const steps = await stepsOf(page);
    await page.keyboard.press(',');
    await expect.poll(() => stepsOf(page)).toBe(steps - 1);
    await page.locator('canvas').focus();
    await page.keyboard.press('[');
    await expect.poll(() => stepsOf(page)).toBe(steps - 61);
    await page.keyboard.press(']');
    await expect.poll(() => stepsOf(page)).toBe(steps - 1);
    await page.keyboard.press('i');
    await expect(page.locator('.statistics')).toContainText('alive');
    await expect(async () => {
      await page.keyboard.press('.');
      await expect(page.locator('.statistics')).toContainText(/^GPU \d+\.\d ms$/m, { timeout: 500 });
    }).toPass();
    await page.keyboard.press('i');
    expect(await ask(page, (stage) => stage.stats.gpuMs)).toBe(undefined);
    await page.keyboard.press('f');
    await expect.poll(() => page.evaluate(() => document.fullscreenElement !== null)).toBe(true);
    await page.keyboard.press('f');
    await expect.poll(() => page.evaluate(() => document.fullscreenElement !== null)).toBe(false);
  });
  await test.step('the knob stays at its position during the seek', async () => {
    const knobs = await page.evaluateHandle(() => {
      const knob = document.querySelector<HTMLInputElement>('input.timeline')!;
      const seen: number[] = [];
      window.cartoonSmoke!.on('frame', () => seen.push(knob.valueAsNumber));
      // The second seek cancels the first, which still draws the step that it has reached.
      for (const seconds of [9, 4]) {
        knob.value = String(seconds);
        knob.dispatchEvent(new Event('input'));
      }
      return seen;
    });
    await expect.poll(() => stepsOf(page)).toBe(240);
    await expect.poll(() => knobs.evaluate(({ length }) => length)).toBeGreaterThan(1);
    expect(await knobs.evaluate((seen) => [...new Set(seen)])).toEqual([4]);
  });
  await test.step('presets passed by keys are undone together, clicked ones one by one', async () => {
    await page.keyboard.press('g');
    const chosen = (name: string) => expect(page.getByRole('radio', { name, exact: true })).toBeChecked();
    const expectPreset = (name: string) =>
      expect.poll(() => page.evaluate(() => location.hash)).toBe(`#v=1&preset=${name}`);
    await page.getByRole('radio', { name: 'Noir' }).check();
    await expectPreset('lamp-noir');
    for (let press = 0; press < 3; ++press) await page.keyboard.press('ArrowRight');
    await expect(page.getByRole('radio', { name: 'Noir' })).not.toBeChecked();
    await page.keyboard.press('Control+z');
    await chosen('Noir');
    await page.keyboard.press('Control+z');
    await chosen('Lamp');
    await page.getByRole('radio', { name: 'Noir' }).check();
    await page.getByRole('radio', { name: 'Ghost', exact: true }).check();
    await page.keyboard.press('Control+z');
    await chosen('Noir');
  });
});

test('a long seek on the timeline shows progress, and a button or Escape stops it', async ({ page }) => {
  await open(page, `?paused=1${LIGHT}`);
  await crawl(page);
  const goFar = () =>
    page.evaluate(() => {
      const press = new KeyboardEvent('keydown', { key: ']', bubbles: true });
      for (let second = 0; second < 400; ++second) document.body.dispatchEvent(press);
    });
  const bar = page.getByRole('progressbar', { name: 'Seeking to' });
  await goFar();
  await expect(bar).toHaveAttribute('aria-label', 'Seeking to 400 s\u2026');
  await page.getByRole('button', { name: 'Stop here' }).click();
  await expect(bar).toHaveCount(0);
  const stopped = await stepsOf(page);
  expect(stopped).toBeGreaterThan(0);
  expect(stopped).toBeLessThan(24_000);
  await goFar();
  await expect(bar).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(bar).toHaveCount(0);
  expect(await stepsOf(page)).toBeLessThan(stopped + 24_000);
  await expect
    .poll(async () => (await line(page).inputValue().then(Number)) - (await stepsOf(page)) / 60)
    .toBeCloseTo(0, 0);
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test('a finger scrubs, and chooses presets in the gallery @long', async ({ page }) => {
    await open(page, `?paused=1${LAMP}`);
    await expectScrubbing(page, await fingerOf(page));
    const gallery = page.getByRole('radiogroup', { name: 'Presets' });
    await gallery.getByRole('radio', { name: 'Noir' }).tap();
    await expect.poll(() => ask(page, (stage) => stage.get()['style.outlineWidth'])).toBe(4);
    await expect.poll(() => page.evaluate(() => location.hash)).toBe('#v=1&preset=lamp-noir');
    await page.keyboard.press('ArrowRight');
    await expect(gallery.getByRole('radio', { name: 'Sunset' })).toBeChecked();
    await page.keyboard.press('Control+z');
    await expect(gallery.getByRole('radio', { name: 'Noir' })).toBeChecked();
    const finger = await fingerOf(page);
    const box = (await gallery.boundingBox())!;
    await finger({ x: 300, y: box.y + 60 }, { x: 60, y: box.y + 60 });
    await expect.poll(() => gallery.evaluate((strip) => strip.scrollLeft)).toBeGreaterThan(0);
  });
});
