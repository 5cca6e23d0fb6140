/** Debian's Firefox, driven by WebDriver BiDi; Playwright requires its own build of Firefox. */
import puppeteer from 'puppeteer-core';
import { LIMIT, RENDERER, type Driver } from './driver.ts';
import { startDisplay } from './display.ts';

export async function startFirefox(path: string): Promise<Driver> {
  const display = await startDisplay();
  const browser = await puppeteer.launch({
    browser: 'firefox',
    executablePath: path,
    headless: false,
    env: display.environment,
    protocolTimeout: LIMIT,
    timeout: LIMIT,
  });
  const [page] = await browser.pages();
  return {
    open: async (address) => void (await page.goto(address, { timeout: LIMIT })),
    evaluate: (expression) => page.evaluate(expression),
    renderer: async () => String(await page.evaluate(RENDERER)),
    close: async () => {
      try {
        await browser.close();
      } finally {
        await display.stop();
      }
    },
  };
}
