import { connect } from 'node:net';
import type { Browser, LaunchOptions, Page, PlaywrightWorkerArgs } from '@playwright/test';
import { findFreePort } from './server.ts';

/** Two tabs of one window. */
export interface Tabs {
  readonly page: Page;
  readonly other: Page;
  close(): Promise<void>;
}

/**
 * Opens tabs that hide each other, as in a regular browser. Playwright emulates focus for its own pages, which are then
 * always visible; it does not do so for the default context of a browser that it connects to.
 */
export async function openTabs(
  { chromium }: PlaywrightWorkerArgs['playwright'],
  options: LaunchOptions,
): Promise<Tabs> {
  const port = await findFreePort();
  const browser = await chromium.launch({
    ...options,
    // A headless browser hides no tab.
    executablePath: process.env.CHROMIUM_PATH,
    args: [...(options.args ?? []), `--remote-debugging-port=${port}`],
  });
  // The browser opens the port some time after its start.
  while (!(await listensOn(port)));
  const seen: Browser = await chromium.connectOverCDP(`http://127.0.0.1:${port}`, { noDefaults: true, timeout: 0 });
  const [context] = seen.contexts();
  const [page, other] = [await context.newPage(), await context.newPage()];
  await page.bringToFront();
  return { page, other, close: () => browser.close() };
}

/** Resolves when a tab has this visibility state. */
export async function isNow(page: Page, state: DocumentVisibilityState): Promise<void> {
  await page.evaluate(async (wanted) => {
    while (document.visibilityState !== wanted) {
      await new Promise((resolve) => document.addEventListener('visibilitychange', resolve, { once: true }));
    }
  }, state);
}

function listensOn(port: number): Promise<boolean> {
  return new Promise((resolve) => {
    const socket = connect(port, '127.0.0.1', () => {
      socket.destroy();
      resolve(true);
    });
    socket.once('error', () => setTimeout(() => resolve(false), 20));
  });
}
