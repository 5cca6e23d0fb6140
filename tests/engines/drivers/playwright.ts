/** Chromium, and Playwright's builds of Firefox and WebKit. */
import type { BrowserType, LaunchOptions } from '@playwright/test';
import { LIMIT, RENDERER, type Driver } from './driver.ts';

export async function startPlaywright(type: BrowserType, options: LaunchOptions): Promise<Driver> {
  const browser = await type.launch(options);
  const page = await browser.newPage();
  page.setDefaultTimeout(LIMIT);
  return {
    open: async (address) => void (await page.goto(address)),
    evaluate: (expression) => page.evaluate(expression),
    renderer: () => page.evaluate<string>(RENDERER),
    close: () => browser.close(),
  };
}
