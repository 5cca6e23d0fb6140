/**
 * The `test` of every browser test: the page must not complain on its console, and what draws must be SwiftShader,
 * because on anything else the pictures mean something else.
 */
import { expect, test as base, type Page } from '@playwright/test';
import { loadModule, type LoadModule } from './modules.ts';
import { watchComplaints } from './complaints.ts';

interface TestFixtures {
  /** Complaints of the page that a test provokes on purpose; any other makes it fail. `test.use({ allowed: /…/ })` */
  allowed: RegExp;
  /** A page without anything of ours on it, for tests of single modules. */
  blank: Page;
  /** Imports a source module inside the blank page, such as '/src/puffs/mesh.ts', and gives a handle on it. */
  load: LoadModule;
}

interface WorkerFixtures {
  /** The unmasked renderer string of WebGL 2, checked once for each browser that is started. */
  renderer: string;
}

export const test = base.extend<TestFixtures, WorkerFixtures>({
  allowed: [/^none$/, { option: true }],
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
  page: async ({ page, allowed }, use) => {
    const complaints = watchComplaints(page);
    await use(page);
    const unexpected = complaints.filter((text) => !allowed.test(text));
    expect(unexpected, 'complaints of the page').toEqual([]);
  },
  blank: async ({ page }, use) => {
    await page.goto('/tests/support/blank.html');
    await use(page);
  },
  load: async ({ blank }, use) => {
    await use((path) => loadModule(blank, path));
  },
});

export { expect };

function rendererString(): string {
  const gl = document.createElement('canvas').getContext('webgl2');
  const extension = gl?.getExtension('WEBGL_debug_renderer_info');
  return gl && extension ? String(gl.getParameter(extension.UNMASKED_RENDERER_WEBGL)) : 'no WebGL 2';
}
