import { createServer, type AddressInfo } from 'node:net';
import type { Browser, LaunchOptions, Page, PlaywrightWorkerArgs } from '@playwright/test';

/** Two tabs of one window. */
export interface Tabs {
  readonly page: Page;
  readonly other: Page;
  close(): Promise<void>;
}

/**
 * Opens tabs that hide one another, as people have them. The runner's own pages are all told that they are in front,
 * whatever lies over them; only the first context of a browser that it finds running is left as it is.
 */
export async function openTabs(
  { chromium }: PlaywrightWorkerArgs['playwright'],
  options: LaunchOptions,
): Promise<Tabs> {
  const port = await freePort();
  const browser = await chromium.launch({
    ...options,
    args: [...(options.args ?? []), `--remote-debugging-port=${port}`],
  });
  const seen: Browser = await chromium.connectOverCDP(`http://127.0.0.1:${port}`, { noDefaults: true });
  const [context] = seen.contexts();
  const [page, other] = [await context.newPage(), await context.newPage()];
  await page.bringToFront();
  return { page, other, close: () => browser.close() };
}

/** Settled when a tab knows whether it is hidden. */
export async function isNow(page: Page, state: DocumentVisibilityState): Promise<void> {
  await page.evaluate(async (wanted) => {
    while (document.visibilityState !== wanted) {
      await new Promise((resolve) => document.addEventListener('visibilitychange', resolve, { once: true }));
    }
  }, state);
}

function freePort(): Promise<number> {
  return new Promise((resolve) => {
    const server = createServer().listen(0, '127.0.0.1', () => {
      const { port } = server.address() as AddressInfo;
      server.close(() => resolve(port));
    });
  });
}
