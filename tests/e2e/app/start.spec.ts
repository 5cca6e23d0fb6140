/** Load on the visitor's machine after the start. */
import { watchConsole } from '../../support/consoleErrors.ts';
import { expect, test } from '../../support/fixtures.ts';
import { slowness, TASK_CATEGORIES, tasksAfter } from '../../support/longTasks.ts';

test.use({ deviceScaleFactor: 1 });

test('at default settings no task takes longer than 200 ms once smoke plays', async ({ page, browser }) => {
  await page.goto('/');
  await page.waitForFunction(() => window.cartoonSmoke?.playing);
  await browser.startTracing(page, { categories: TASK_CATEGORIES });
  const start = await page.evaluate(() => {
    performance.mark('plays');
    return window.cartoonSmoke!.stats.time;
  });
  await page.waitForFunction((time) => window.cartoonSmoke!.stats.time > time + 1, start);
  const tasks = tasksAfter('plays', await browser.stopTracing());
  // Draw calls are among the tasks, but another process does the work.
  expect(tasks.length).toBeGreaterThan(20);
  expect(tasks[0]).toBeGreaterThan(0);
  expect(tasks[0]).toBeLessThan(200 * slowness());
});

test('nothing is written to the console', async ({ page }) => {
  const lines = watchConsole(page);
  await page.goto('/');
  await page.waitForFunction(() => (window.cartoonSmoke?.stats.bodiesDrawn ?? 0) > 0);
  expect(lines).toEqual([]);
});
