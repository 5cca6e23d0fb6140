import type { ConsoleMessage, Page } from '@playwright/test';

/**
 * Collects what goes wrong on a page: errors on the console, exceptions that nobody caught, and what WebGL warns of,
 * which is how a wrong call shows. Advice of the driver about speed is left out.
 *
 * @returns A list that grows while the page lives.
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
