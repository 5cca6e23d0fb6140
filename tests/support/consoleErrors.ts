import type { ConsoleMessage, Page } from '@playwright/test';

/**
 * Collects console errors, uncaught exceptions and WebGL warnings of a page. An invalid WebGL call causes such a
 * warning. Performance hints of the driver are ignored.
 *
 * @returns A list that grows as long as the page is open.
 */
export function watchConsoleErrors(page: Page): string[] {
  const consoleErrors: string[] = [];
  page.on('console', (message) => {
    if (isConsoleError(message)) consoleErrors.push(`${message.type()}: ${message.text()}`);
  });
  page.on('pageerror', (error) => consoleErrors.push(`exception: ${error.message}`));
  return consoleErrors;
}

function isConsoleError(message: ConsoleMessage): boolean {
  if (message.type() === 'error') return true;
  return message.type() === 'warning' && /webgl|gl_/i.test(message.text()) && !/performance/i.test(message.text());
}

/** Messages of Chromium's graphics driver and of the test tools, which no page can prevent. */
const OF_BROWSER = /GPU stall due to ReadPixels|Service Worker registration blocked/;

/** Collects every console line of a page, except those of the browser itself. */
export function watchConsole(page: Page): string[] {
  const lines: string[] = [];
  page.on('console', (message) => {
    if (!OF_BROWSER.test(message.text())) lines.push(message.text());
  });
  return lines;
}
