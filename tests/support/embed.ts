/** The `test` of host pages: they load the package as published on npm, without a bundler. */
import type { Page } from '@playwright/test';
import { expect, test as base } from './fixtures.ts';
import type { SiteServer as Server } from './plainPage.ts';

export interface PageOptions {
  /** Script of the page; the modules of the package by default, with three.js next to them. */
  script?: string;
  style?: string;
  headers?: Record<string, string>;
}

/** Opens a page with this body and resolves when it is loaded. */
export type OpenPage = (body: string, options?: PageOptions) => Promise<void>;

export const MODULES = `
  <script type="importmap">{ "imports": { "three": "/node_modules/three/build/three.module.js" } }</script>
  <script type="module" src="/package/dist/element.js"></script>`;
/** The cheapest smoke. */
export const WISP = 'preset="wisp" simulation-max-particles="300" puff-variations="1" thread="main"';

export const test = base.extend<{ openPage: OpenPage }>({
  openPage: async ({ page, server }, use) => {
    await use((body, options) => showPage(page, server, body, options));
  },
});

export { expect, type Server };

/** Shows a host page with this body. */
export async function showPage(
  page: Page,
  server: Server,
  body: string,
  { script: loaded = MODULES, style = '', headers = {} }: PageOptions = {},
): Promise<void> {
  server.sent.length = 0;
  const head = `<meta charset="utf-8"><title>Somebody's page</title>${style && `<style>${style}</style>`}${loaded}`;
  await page.route('**/host.html', (route) =>
    route.fulfill({ contentType: 'text/html', headers, body: `<!doctype html><html lang="en">${head}${body}` }),
  );
  await page.goto(`${server.address}host.html`);
}

/** Scrolls a page without waiting for its frames. Resolves after all IntersectionObserver callbacks. */
export async function scrollPage(page: Page, top: number): Promise<void> {
  await page.evaluate(async (y) => {
    scrollTo(0, y);
    await new Promise((resolve) => new IntersectionObserver(resolve).observe(document.body));
    // All observers are called in one task.
    await new Promise((resolve) => setTimeout(resolve));
  }, top);
}

/** Waits for `count` frames of a page. */
export async function frames(page: Page, count: number): Promise<void> {
  await page.evaluate(async (max) => {
    for (let frame = 0; frame < max; ++frame) await new Promise(requestAnimationFrame);
  }, count);
}

/** Resolves when the smoke of the first matching element is ready. */
export async function stands(page: Page, selector = 'cartoon-smoke'): Promise<void> {
  await page.waitForFunction(async (wanted) => {
    const element = document.querySelector(wanted) as { ready?: Promise<void> } | null;
    if (!element?.ready) return false;
    await element.ready;
    return true;
  }, selector);
}
