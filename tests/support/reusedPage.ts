import type { Browser, BrowserContext, Page, PlaywrightTestOptions } from '@playwright/test';
import { watchConsoleErrors } from './consoleErrors.ts';

const BLANK = '/tests/support/blank.html';

/**
 * A page without anything of ours that all tests of a file use one after the other, so that modules are loaded, puffs
 * baked and shaders compiled once a file and not once a test. The next file finds it as new.
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

  /** The page, ready for a test of this file. @param file path that tells files apart */
  async forTestOf(file: string): Promise<Page> {
    this.opened ??= await this.open();
    const { page } = this.opened;
    if (this.file !== file) {
      await page.goto(BLANK);
      this.file = file;
    }
    return page;
  }

  /**
   * What the page complained of since this was last asked. What came after the end of a test counts for the next one:
   * late, but not lost.
   */
  async consoleErrors(): Promise<string[]> {
    if (!this.opened) return [];
    // What the page has said before it answers has arrived when its answer has.
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
    const { baseURL, viewport, deviceScaleFactor } = this.options;
    const context = await this.browser.newContext({ baseURL, viewport, deviceScaleFactor });
    const page = await context.newPage();
    return { context, page, consoleErrors: watchConsoleErrors(page) };
  }
}
