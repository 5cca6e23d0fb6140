/** Tabs hidden by another tab. */
import type { Page } from '@playwright/test';
import type { CartoonSmokeElement } from '../../../../src/page/element/cartoonSmokeElement.ts';
import { expect, showPage, stands, test, WISP } from '../../../support/embed.ts';
import { isNow, openTabs, type Tabs } from '../../../support/tabs.ts';

const BOX = 'style="width: 200px; height: 150px"';

async function switchTo(tabs: Tabs, which: 'page' | 'other'): Promise<void> {
  await tabs[which].bringToFront();
  await isNow(tabs.page, which === 'page' ? 'visible' : 'hidden');
}

function stepsOf(page: Page): Promise<number> {
  return page.locator('cartoon-smoke').evaluate(async (element: CartoonSmokeElement) => (await element.stats()).steps);
}

/** Steps during a number of frames of a visible tab, after pending messages. */
async function stepsWhile(page: Page, seen: Page): Promise<number> {
  const frames = () =>
    seen.evaluate(async () => {
      for (let frame = 0; frame < 20; ++frame) await new Promise(requestAnimationFrame);
    });
  await frames();
  const before = await stepsOf(page);
  await frames();
  return (await stepsOf(page)) - before;
}

// On the main thread a hidden page has no frames anyway.
test('in a worker, rests in a hidden tab, continues in front, and stays paused if the user paused it', async ({
  playwright,
  launchOptions,
  server,
}) => {
  const tabs = await openTabs(playwright, launchOptions);
  const { page, other } = tabs;
  await showPage(page, server, `<cartoon-smoke ${WISP.replace('main', 'worker')} ${BOX}></cartoon-smoke>`);
  await stands(page);
  await expect.poll(() => stepsOf(page)).toBeGreaterThan(2);
  await switchTo(tabs, 'other');
  expect(await stepsWhile(page, other)).toBe(0);
  expect(await page.locator('cartoon-smoke').evaluate((smoke: CartoonSmokeElement) => smoke.playing)).toBe(true);
  const before = await stepsOf(page);
  await switchTo(tabs, 'page');
  await expect.poll(() => stepsOf(page)).toBeGreaterThan(before);
  await page.getByRole('button', { name: 'Pause smoke' }).click();
  await switchTo(tabs, 'other');
  await switchTo(tabs, 'page');
  expect(await stepsWhile(page, page)).toBe(0);
  await expect(page.getByRole('button', { name: 'Play smoke' })).toBeVisible();
  await tabs.close();
});
