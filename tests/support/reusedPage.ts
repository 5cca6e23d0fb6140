import type { Browser, BrowserContext, Page, PlaywrightTestOptions } from '@playwright/test';
import { watchConsoleErrors } from './consoleErrors.ts';

const BLANK = '/tests/support/blank.html';

/**
 * A page without product code that all tests of a file share, so that modules are loaded, puffs baked and shaders
 * compiled once per file instead of once per test. The next file gets a fresh page.
 */
export class ReusedPage {
  private readonly browser: Browser;
  private readonly options: Partial<PlaywrightTestOptions>;
  private opened: { context: BrowserContext; page: Page; consoleErrors: string[] } | undefined;
  private file: string | undefined;

  constructor(browser: Browser, options: Partial<PlaywrightTestOptions>) {
    this.browser = browser;
    this.options = options;
  }

  /** The page, prepared for a test of this file. @param file path of the test file */
  async forTestOf(file: string): Promise<Page> {
    this.opened ??= await this.open();
    const { page } = this.opened;
    if (this.file !== file) {
      await page.goto(BLANK);
      this.file = file;
    }
    return page;
  }

  /** Console errors of the page since the last call. Errors after the end of a test are reported by the next one. */
  async consoleErrors(): Promise<string[]> {
    if (!this.opened) return [];
    // Messages that the page logs before this evaluation arrive before its result.
    await this.opened.page.evaluate(() => {
      document.body.replaceChildren();
      document.body.removeAttribute('style');
    });
    return this.opened.consoleErrors.splice(0);
  }

  async close(): Promise<void> {
    await this.opened?.context.close();
  }

  private async open() {
    const { baseURL, viewport } = this.options;
    const context = await this.browser.newContext({ baseURL, viewport, deviceScaleFactor: 1 });
    const page = await context.newPage();
    return { context, page, consoleErrors: watchConsoleErrors(page) };
  }
}
