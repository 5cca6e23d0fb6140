import { expect, test } from '../../support/fixtures.ts';
import { gpuKeepsUp } from '../../support/gpuKeepsUp.ts';
import { ask, LIGHT, messagesOf, open } from './page.ts';

test('a slow machine gets one message and draws fewer pixels', async ({ page }) => {
  // The test controls the frames, independent of the machine.
  await page.addInitScript(gpuKeepsUp);
  await page.addInitScript(() => {
    Object.assign(window, { frameMs: 16 });
    const original = requestAnimationFrame;
    let now = 0;
    window.requestAnimationFrame = (callback) =>
      original(() => callback((now += (window as unknown as { frameMs: number }).frameMs)));
  });
  await page.setViewportSize({ width: 200, height: 150 });
  await open(page, LIGHT);
  const notified = await messagesOf(page);
  await expect.poll(() => ask(page, (stage) => stage.stats.steps)).toBeGreaterThan(60);
  expect(await ask(page, (stage) => stage.stats.scale)).toBe(1);
  expect(await notified()).toEqual([]);
  await page.evaluate(() => Object.assign(window, { frameMs: 100 }));
  await expect.poll(notified).toEqual([expect.stringContaining('playback uses fewer pixels')]);
  const steps = await ask(page, (stage) => stage.stats.steps);
  await expect.poll(() => ask(page, (stage) => stage.stats.steps)).toBeGreaterThan(steps + 120);
  expect(await notified()).toHaveLength(1);
});
