/** The `test` of pages of other people: they get the package as npm has it, without a bundler. */
import type { Page } from '@playwright/test';
import { expect, test as base } from './fixtures.ts';
import type { SiteServer as Server } from './plainPage.ts';

export interface PageOptions {
  /** What the page loads; the modules of the package by default, three.js beside them. */
  script?: string;
  style?: string;
  headers?: Record<string, string>;
}

/** Opens a page with this body; answers when it was loaded. */
export type OpenPage = (body: string, options?: PageOptions) => Promise<void>;

export const MODULES = `
  <script type="importmap">{ "imports": { "three": "/node_modules/three/build/three.module.js" } }</script>
  <script type="module" src="/package/dist/element.js"></script>`;
/** The smallest smoke there is. */
export const WISP = 'preset="wisp" simulation-max-particles="300" puff-variations="1" thread="main"';

export const test = base.extend<{ openPage: OpenPage }>({
  openPage: async ({ page, server }, use) => {
    await use((body, options) => showPage(page, server, body, options));
  },
});

export { expect, type Server };

/** Shows a page of somebody else's with this body. */
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

/** Scrolls a page, whatever its first frames wait for; settled when whoever observes what is in view has been told. */
export async function scrollPage(page: Page, top: number): Promise<void> {
  await page.evaluate(async (y) => {
    scrollTo(0, y);
    await new Promise((resolve) => new IntersectionObserver(resolve).observe(document.body));
    // All observers are told in one task.
    await new Promise((resolve) => setTimeout(resolve));
  }, top);
}

/** Lets a page show so many frames. */
export async function frames(page: Page, count: number): Promise<void> {
  await page.evaluate(async (max) => {
    for (let frame = 0; frame < max; ++frame) await new Promise(requestAnimationFrame);
  }, count);
}

/** Settled when the smoke of the first element that fits stands. */
export async function stands(page: Page, selector = 'cartoon-smoke'): Promise<void> {
  await page.waitForFunction(async (wanted) => {
    const element = document.querySelector(wanted) as { ready?: Promise<void> } | null;
    if (!element?.ready) return false;
    await element.ready;
    return true;
  }, selector);
}
