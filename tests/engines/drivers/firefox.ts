/** Debian's Firefox, which speaks WebDriver BiDi; Playwright needs a Firefox of its own. */
import puppeteer from 'puppeteer-core';
import type { Driver } from './driver.ts';
import { startDisplay } from './display.ts';

export async function startFirefox(path: string, limit: number): Promise<Driver> {
  const display = await startDisplay();
  const browser = await puppeteer.launch({
    browser: 'firefox',
    executablePath: path,
    headless: false,
    env: display.environment as Record<string, string>,
    protocolTimeout: limit,
    timeout: limit,
  });
  const page = await browser.newPage();
  return {
    open: async (address) => void (await page.goto(address, { timeout: limit })),
    evaluate: (expression) => page.evaluate(expression),
    close: async () => {
      await browser.close();
      await display.stop();
    },
  };
}
