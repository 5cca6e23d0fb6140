import { defineConfig } from '@playwright/test';
import type { WorkerOptions } from './tests/support/fixtures.ts';
import { requireTestServer } from './tests/support/server.ts';

const isLong = Boolean(process.env.TEST_LONG);
// Playwright compares it with the path of the file and the titles.
const LONG = /\.long\.spec\.ts|@long/;

const EMBED = '**/tests/e2e/{package,page,stage}/**/*.spec.ts';
const SITE = '**/tests/site/*.spec.ts';

// These tests check the page. Where the picture matters, they request the full resolution.
const fewPixels = { deviceScaleFactor: 0.25 };
const halfThePixels = { deviceScaleFactor: 0.5 };
// For text, boxes and pixel readback, the CPU rasterizer is faster than SwiftShader. WebGL content is not affected.
const plainCanvases = ['--disable-gpu-rasterization', '--disable-accelerated-2d-canvas'];
// Pages live for seconds, in which optimised code does not repay its compilation: for WASM a tenth of all CPU time, for
// JavaScript a quarter of the renderer's.
const unoptimisedWasm = '--liftoff-only';
const unoptimised = `--no-opt --single-threaded ${unoptimisedWasm}`;
// Otherwise each worker would build a missing site or package.
const builtFirst = { dependencies: ['built'] };

const { port, browser, flags } = await requireTestServer();
const launched = (scriptFlags: string) => ({
  launchOptions: {
    executablePath: browser,
    args: [...flags, ...plainCanvases, `--js-flags=${scriptFlags}`],
  },
});
const brief = launched(unoptimised);

/**
 * Tests in a browser: source modules on a separate development server, and pages as published, all rendered by
 * SwiftShader. Files named *.long.spec.ts and tests with @long in their title run only in `npm run test:long`.
 */
export default defineConfig<object, WorkerOptions>({
  testDir: 'tests',
  ...(isLong ? { grep: LONG } : { grepInvert: LONG }),
  forbidOnly: true,
  retries: 0,
  // Tests mostly wait for the page, so four workers fit on two cores. The long tests use more processor time.
  workers: isLong ? 2 : 4,
  // Sufficient for slow machines. A longer timeout costs time only when a test fails.
  timeout: isLong ? 900_000 : 600_000,
  expect: { timeout: 120_000 },
  outputDir: 'test-results',
  projects: [
    { name: 'built', testMatch: '**/tests/support/built.setup.ts', grep: /./ },
    // Needs no build, but without this dependency all others would wait for its last test.
    { name: 'modules', testMatch: '**/tests/visual/**/*.spec.ts', ...builtFirst },
    // Third-party pages, with the files that npm and CDNs would deliver.
    { name: 'embed', testMatch: EMBED, ...builtFirst, use: { ...halfThePixels, ...brief } },
    { name: 'site', testMatch: SITE, ...builtFirst, use: fewPixels },
    {
      name: 'pages',
      ...builtFirst,
      testMatch: '**/tests/e2e/**/*.spec.ts',
      testIgnore: EMBED,
      // Each test is a first visit to the page; the service worker has separate tests, with those of the site.
      use: { ...fewPixels, ...brief, showsBuiltSite: true, serviceWorkers: 'block' },
    },
  ],
  reporter: 'list',
  use: {
    baseURL: `http://localhost:${port}`,
    viewport: { width: 640, height: 360 },
    deviceScaleFactor: 1,
    ...launched(unoptimisedWasm),
  },
  webServer: {
    command: `node node_modules/vite/bin/vite.js --config tests/support/vite.config.ts --port ${port} --strictPort`,
    url: `http://localhost:${port}/tests/support/blank.html`,
    timeout: 300_000,
  },
});
