/**
 * The `test` of every browser test. The page must not log errors, and the WebGL renderer must be SwiftShader, because
 * pictures differ between renderers.
 */
import { expect, test as base, type Page } from '@playwright/test';
import { serveBuiltSite } from './builtSite.ts';
import { watchConsoleErrors } from './consoleErrors.ts';
import { ReusedPage } from './reusedPage.ts';
import { loadModule, type LoadModule } from './modules.ts';
import { serveRepository, type SiteServer } from './plainPage.ts';

interface TestFixtures {
  /** Console messages that a test provokes; all others make it fail. `test.use({ allowed: /…/ })` */
  allowed: RegExp;
  /** Whether `blank` is a separate page: for tests of resources that a page keeps, such as contexts and memory. */
  ownPage: boolean;
  /** Whether the demo page explains itself, as at the first visit. Its hint would cover what other tests press. */
  isFirstVisit: boolean;
  /** A page without product code, for tests of single modules; shared by all tests of a file. */
  blank: Page;
  /** Imports a source module in the blank page, such as '/src/renderer/puffs/billboards/mesh.ts', and returns its handle. */
  load: LoadModule;
}

export interface WorkerOptions {
  /** Whether `page` shows the built site; otherwise the sources on the development server. */
  showsBuiltSite: boolean;
}

interface WorkerFixtures extends WorkerOptions {
  /** URL of the built site, if shown. */
  site: string | undefined;
  /** The unmasked renderer string of WebGL 2, checked once per browser. */
  renderer: string;
  reused: ReusedPage;
  /**
   * Server of host pages. It is a fixture of all browser tests, so that tests of host pages and of the element share a
   * browser.
   */
  server: SiteServer;
}

export const test = base.extend<TestFixtures, WorkerFixtures>({
  allowed: [/^none$/, { option: true }],
  ownPage: [false, { option: true }],
  isFirstVisit: [false, { option: true }],
  renderer: [
    async ({ browser }, use) => {
      const page = await browser.newPage();
      const renderer = await page.evaluate(rendererString);
      await page.close();
      expect(renderer, 'the WebGL renderer of the tests').toContain('SwiftShader');
      await use(renderer);
    },
    { scope: 'worker', auto: true },
  ],
  showsBuiltSite: [false, { option: true, scope: 'worker' }],
  site: [
    async ({ showsBuiltSite }, use) => {
      const site = showsBuiltSite ? await serveBuiltSite() : undefined;
      await use(site?.address);
      await site?.stop();
    },
    { scope: 'worker' },
  ],
  baseURL: async ({ baseURL, site }, use) => {
    await use(site ?? baseURL);
  },
  reused: [
    async ({ browser }, use, { project }) => {
      const reused = new ReusedPage(browser, project.use);
      await use(reused);
      await reused.close();
    },
    { scope: 'worker' },
  ],
  server: [
    // oxlint-disable-next-line no-empty-pattern -- what it needs is no fixture, and the runner reads the pattern
    async ({}, use) => {
      const server = await serveRepository();
      await use(server);
      await server.close();
    },
    { scope: 'worker' },
  ],
  page: async ({ page, allowed, isFirstVisit }, use) => {
    if (!isFirstVisit) await page.addInitScript(knowGestures);
    const consoleErrors = watchConsoleErrors(page);
    await use(page);
    expectNone(consoleErrors, allowed);
  },
  blank: async ({ browser, reused, ownPage, allowed }, use, { file, project }) => {
    const one = ownPage ? new ReusedPage(browser, project.use) : reused;
    await use(await one.forTestOf(file));
    expectNone(await one.consoleErrors(), allowed);
    if (ownPage) await one.close();
  },
  load: async ({ blank }, use) => {
    await use((path) => loadModule(blank, path));
  },
});

export { expect };

/** The tag in the title of a row of a table: a row with a true condition runs only in `npm run test:long`. */
export function longIf(condition: boolean): string {
  return condition ? ' @long' : '';
}

function expectNone(consoleErrors: string[], allowed: RegExp): void {
  const unexpected = consoleErrors.filter((text) => !allowed.test(text));
  expect(unexpected, 'errors on the console of the page').toEqual([]);
}

/** Runs in a page: it is no first visit. */
export function knowGestures(): void {
  try {
    localStorage.setItem('cartoon-smoke.knowsGestures', '1');
  } catch {
    // Denied, as in sandboxed frames.
  }
}

function rendererString(): string {
  const gl = document.createElement('canvas').getContext('webgl2');
  const extension = gl?.getExtension('WEBGL_debug_renderer_info');
  return gl && extension ? String(gl.getParameter(extension.UNMASKED_RENDERER_WEBGL)) : 'no WebGL 2';
}
