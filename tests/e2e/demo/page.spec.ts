import { expect, test } from '../../support/fixtures.ts';
import { ask, crawl, expectSteps, LAMP, LIGHT, messagesOf, open } from './page.ts';

test('smoke appears and plays, and nothing is requested from another host', async ({ page }) => {
  const requests: string[] = [];
  page.on('request', (request) => requests.push(request.url()));
  await open(page, LIGHT);
  await expect.poll(() => ask(page, (stage) => stage.stats.bodiesDrawn)).toBeGreaterThan(0);
  const steps = await ask(page, (stage) => stage.stats.steps);
  await expect.poll(() => ask(page, (stage) => stage.stats.steps)).toBeGreaterThan(steps);
  await expect(page.getByRole('button', { name: 'Pause', exact: true })).toBeVisible();
  await expect(page.getByRole('progressbar')).toHaveCount(0);
  const own = new URL(page.url()).origin;
  expect(requests.filter((url) => !url.startsWith(own) && !url.startsWith('data:'))).toEqual([]);
});

test('only the smoke is printed; a value of ?t= out of range is clamped, with a message', async ({ page }) => {
  await page.setViewportSize({ width: 1100, height: 700 });
  await open(page, `?paused=1&t=-3${LAMP}&emission.rate=bad`);
  await expect(page.getByText('t cannot be “-3”')).toBeVisible();
  const printed = () =>
    page.evaluate(() =>
      [...document.body.querySelectorAll('*')]
        .filter((each) => each.checkVisibility())
        .map(({ localName }) => localName),
    );
  for (const key of ['', 's', 'Escape', '?', 'Escape', 'c']) {
    if (key) await page.keyboard.press(key);
    await page.emulateMedia({ media: 'print' });
    expect(await printed(), `after ${key}`).toEqual(['main', 'div', 'canvas']);
    await page.emulateMedia({ media: 'screen' });
    expect((await printed()).length).toBeGreaterThan(20);
  }
});

test('loading shows progress', async ({ page }) => {
  let letGo: () => void = () => undefined;
  const seen = new Promise<void>((resolve) => (letGo = resolve));
  await page.route('**/*.wasm*', async (route) => {
    await seen;
    await route.continue();
  });
  await page.goto(`/?paused=1${LAMP}`, { waitUntil: 'commit' });
  await expect(page.getByRole('progressbar', { name: 'Rubbing the lamp' })).toBeVisible();
  letGo();
  await page.waitForFunction(() => window.cartoonSmoke !== undefined);
  await expect(page.getByRole('progressbar')).toHaveCount(0);
});

test('buttons play, pause, step and restart, and the panel follows the console', async ({ page }) => {
  await page.setViewportSize({ width: 760, height: 540 });
  await open(page, `?paused=1${LIGHT}`);
  await test.step('play, pause, step and restart', async () => {
    const steps = () => ask(page, (stage) => stage.stats.steps);
    expect(await steps()).toBe(0);
    const bar = page.getByRole('group', { name: 'Playback' });
    await bar.getByRole('button', { name: 'One step' }).click();
    await bar.getByRole('button', { name: 'One step' }).click();
    expect(await steps()).toBe(2);
    await bar.getByRole('button', { name: 'Play' }).click();
    await expect.poll(steps).toBeGreaterThan(2);
    await bar.getByRole('button', { name: 'Pause' }).click();
    expect(await ask(page, (stage) => stage.playing)).toBe(false);
    await bar.getByRole('button', { name: 'Start over' }).click();
    expect(await steps()).toBe(0);
    await bar.getByLabel('Speed').selectOption({ label: '¼×' });
    expect(await ask(page, (stage) => stage.speed)).toBe(0.25);
  });
  await test.step('values set from the console reach the panel and the link', async () => {
    await ask(page, (stage) => stage.set({ 'puff.size': 1.5 }));
    await expect(page.getByLabel('Puff size, exact value')).toHaveValue('1.5');
    await expect.poll(() => page.url()).toContain('puff.size=1.5');
  });
});

test('?t= seeks before the first frame, and ?stats=1 shows statistics', async ({ page }) => {
  await open(page, `?paused=1&t=1.5&stats=1${LIGHT}`);
  await expectSteps(page, 90);
  await expect(page.getByText('1.5 s', { exact: true })).toBeVisible();
  await expect(page.locator('.statistics')).toContainText('alive');
});

test('a long seek shows progress and can be stopped @long', async ({ page }) => {
  await crawl(page);
  await open(page, `?paused=1&t=600${LIGHT}`);
  await expect(page.getByRole('progressbar')).toBeVisible();
  const notified = await messagesOf(page);
  await page.getByRole('button', { name: 'Stop here' }).click();
  await expect.poll(notified).toEqual([expect.stringContaining('Stopped at')]);
  await expect(page.getByRole('progressbar')).toHaveCount(0);
  expect(await ask(page, (stage) => stage.stats.steps)).toBeLessThan(36_000);
});

test('?ui=0 shows only the smoke', async ({ page }) => {
  await open(page, `?ui=0&paused=1&stats=1${LIGHT}&bogus=1`);
  await expect(page.locator('canvas')).toBeVisible();
  await expect(page.locator('button, input, select, p, pre').filter({ visible: true })).toHaveCount(0);
});

test.describe('reduced motion', () => {
  test.use({ contextOptions: { reducedMotion: 'reduce' } });

  test('starts with a still frame of smoke and a play button', async ({ page }) => {
    await open(page, LIGHT);
    const button = page.getByRole('button', { name: 'Play the smoke' });
    await expect(button).toBeVisible();
    expect(await ask(page, (stage) => [stage.playing, stage.stats.bodiesDrawn > 0])).toEqual([false, true]);
    await button.click();
    await expect.poll(() => ask(page, (stage) => stage.playing)).toBe(true);
    await expect(button).toHaveCount(0);
  });
});
