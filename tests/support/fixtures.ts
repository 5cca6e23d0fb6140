/**
 * The `test` of every browser test: the page must not complain on its console, and what draws must be SwiftShader,
 * because on anything else the pictures mean something else.
 */
import { expect, test as base, type Page } from '@playwright/test';
import { serveBuiltSite } from './builtSite.ts';
import { watchConsoleErrors } from './consoleErrors.ts';
import { ReusedPage } from './reusedPage.ts';
import { loadModule, type LoadModule } from './modules.ts';
import { serveRepository, type SiteServer } from './plainPage.ts';

interface TestFixtures {
  /** Complaints of the page that a test provokes on purpose; any other makes it fail. `test.use({ allowed: /…/ })` */
  allowed: RegExp;
  /** Whether `blank` is nobody else's: for tests of what ends with a page, such as contexts and memory. */
  ownPage: boolean;
  /** A page without anything of ours on it, for tests of single modules: one for all tests of a file. */
  blank: Page;
  /** Imports a source module inside the blank page, such as '/src/puffs/billboards/mesh.ts', and gives a handle on it. */
  load: LoadModule;
}

export interface WorkerOptions {
  /** Whether `page` shows the built site; the sources on the development server otherwise. */
  showsBuiltSite: boolean;
}

interface WorkerFixtures extends WorkerOptions {
  /** Address of the built site, where it is shown. */
  site: string | undefined;
  /** The unmasked renderer string of WebGL 2, checked once for each browser that is started. */
  renderer: string;
  reused: ReusedPage;
  /** For pages of other people. It stands here so that their tests and others of the element take turns in one browser. */
  server: SiteServer;
}

export const test = base.extend<TestFixtures, WorkerFixtures>({
  allowed: [/^none$/, { option: true }],
  ownPage: [false, { option: true }],
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
  page: async ({ page, allowed }, use) => {
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

function expectNone(consoleErrors: string[], allowed: RegExp): void {
  const unexpected = consoleErrors.filter((text) => !allowed.test(text));
  expect(unexpected, 'errors on the console of the page').toEqual([]);
}

function rendererString(): string {
  const gl = document.createElement('canvas').getContext('webgl2');
  const extension = gl?.getExtension('WEBGL_debug_renderer_info');
  return gl && extension ? String(gl.getParameter(extension.UNMASKED_RENDERER_WEBGL)) : 'no WebGL 2';
}
