import { defineConfig } from '@playwright/test';
import type { WorkerOptions } from './tests/support/fixtures.ts';
import { demandTestServer } from './tests/support/server.ts';

const isLong = Boolean(process.env.TEST_LONG);
const FOLDERS = '{site,visual,e2e}';
const LONG = `**/${FOLDERS}/**/*.long.{spec,test}.ts`;

const EMBED = isLong ? '**/e2e/embed.*.long.spec.ts' : '**/e2e/embed.*.spec.ts';
const SITE = isLong ? '**/tests/site/*.long.spec.ts' : '**/tests/site/*.spec.ts';

const ignored = isLong ? [] : [LONG];
// What these tests check is the page. Where the picture counts, they ask for all pixels.
const fewPixels = { deviceScaleFactor: 0.25 };
const halfThePixels = { deviceScaleFactor: 0.5 };
// Letters and boxes, and pixels on their way to be read, are drawn sooner by the page itself than by SwiftShader. What is
// drawn with WebGL stays as it is.
const plainCanvases = ['--disable-gpu-rasterization', '--disable-accelerated-2d-canvas'];
// Workers that find something missing would all build it.
const builtFirst = { dependencies: ['built'] };

const { port, browser, flags } = await demandTestServer();

/**
 * Tests that need a browser: source modules on a development server of their own and pages as they are published, all
 * drawn by SwiftShader.
 * Those named *.long.spec.ts run by `npm run test:long` only.
 */
export default defineConfig<object, WorkerOptions>({
  testDir: 'tests',
  testMatch: isLong ? LONG : `**/${FOLDERS}/**/*.{spec,test}.ts`,
  testIgnore: ignored,
  forbidOnly: true,
  retries: 0,
  // Much of what a test takes is waiting for the page to follow, which three at a time fill on two cores. The long ones
  // have the machine to themselves.
  workers: isLong ? 1 : 3,
  // Long enough for the slowest of machines: who waits in vain has found a fault, and may as well wait longer.
  timeout: isLong ? 900_000 : 600_000,
  expect: { timeout: 120_000 },
  outputDir: 'test-results',
  projects: [
    { name: 'built', testMatch: '**/support/built.setup.ts', testIgnore: [] },
    { name: 'modules', testIgnore: [...ignored, '**/e2e/**', SITE] },
    { name: 'site', testMatch: SITE, testIgnore: ignored, ...builtFirst, use: fewPixels },
    {
      name: 'pages',
      ...builtFirst,
      testMatch: isLong ? '**/e2e/**/*.long.spec.ts' : '**/e2e/**/*.spec.ts',
      testIgnore: [...ignored, EMBED],
      // Each test meets the page for the first time; the service worker has tests of its own, beside the site's.
      use: { ...fewPixels, showsBuiltSite: true, serviceWorkers: 'block' },
    },
    // Pages of other people, with what npm and CDNs would give them.
    { name: 'embed', testMatch: EMBED, testIgnore: ignored, ...builtFirst, use: halfThePixels },
  ],
  reporter: 'list',
  use: {
    baseURL: `http://localhost:${port}`,
    viewport: { width: 640, height: 360 },
    deviceScaleFactor: 1,
    launchOptions: { executablePath: browser, args: [...flags, ...plainCanvases] },
  },
  webServer: {
    command: `node node_modules/vite/bin/vite.js --config tests/support/vite.config.ts --port ${port} --strictPort`,
    url: `http://localhost:${port}/tests/support/blank.html`,
    timeout: 300_000,
  },
});
