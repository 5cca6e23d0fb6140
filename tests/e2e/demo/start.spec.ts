/** Load on the visitor's machine after the start. */
import { watchConsole } from '../../support/consoleErrors.ts';
import { expect, test } from '../../support/fixtures.ts';
import { slowness, TASK_CATEGORIES, tasksAfter } from '../../support/longTasks.ts';

test('at default settings no task takes longer than 200 ms once smoke plays, and nothing is written to the console', async ({
  page,
  browser,
}) => {
  const lines = watchConsole(page);
  await page.goto('/');
  await page.waitForFunction(() => window.cartoonSmoke?.playing);
  await browser.startTracing(page, { categories: TASK_CATEGORIES });
  const start = await page.evaluate(() => {
    performance.mark('plays');
    return window.cartoonSmoke!.stats.time;
  });
  await page.waitForFunction((time) => window.cartoonSmoke!.stats.time > time + 1, start);
  // Draw calls are among the tasks, but another process does the work, and it has few pixels here.
  const tasks = tasksAfter('plays', await browser.stopTracing());
  expect(tasks.length).toBeGreaterThan(20);
  expect(tasks[0]).toBeGreaterThan(0);
  expect(tasks[0]).toBeLessThan(200 * slowness());
  expect(await page.evaluate(() => window.cartoonSmoke!.stats.bodiesDrawn)).toBeGreaterThan(0);
  expect(lines).toEqual([]);
});
