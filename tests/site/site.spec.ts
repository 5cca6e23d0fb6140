/** The built site on a static host: in a nested folder, with gzip and a strict Content-Security-Policy. */
import { cpSync, mkdtempSync, readdirSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import type { Page } from '@playwright/test';
import { expect, test } from '../support/fixtures.ts';
import { serveStrictly, type SiteServer } from '../support/plainPage.ts';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const WISP = '#v=1&preset=wisp&simulation.maxParticles=500';

let folder: string;
let server: SiteServer;

test.beforeEach(async () => {
  folder = mkdtempSync(join(tmpdir(), 'cartoon-smoke-site-'));
  cpSync(join(ROOT, 'dist'), folder, { recursive: true });
  server = await serveStrictly(folder);
});
test.afterEach(async ({ page }) => {
  // Before the server closes, or pending requests would fail and log errors.
  await page.close();
  await server.close();
  rmSync(folder, { recursive: true });
});

test('lists the licences of its parts and links to its source', async ({ page }) => {
  await page.goto(`${server.address}?paused=1${WISP}`);
  await page.getByRole('button', { name: 'Help' }).click();
  const link = page.getByRole('link', { name: 'Third-party licences' });
  const answer = await page.request.get(new URL((await link.getAttribute('href'))!, server.address).href);
  const text = await answer.text();
  // Bundled, loaded on demand, used by an example, and linked into the WASM.
  for (const name of ['three', 'mediabunny', 'gifenc', 'react-dom', 'rapier3d', 'glam']) {
    expect(text).toMatch(new RegExp(`^${name} \\d+\\.\\d+\\.\\d+ \\([^\n]+\\)\nhttps://`, 'm'));
  }
  expect(text).toContain('(MPL-2.0)\nhttps://github.com/Vanilagy/mediabunny.git');
  expect(text).toContain('Mozilla Public License Version 2.0');
});

/** Largest size of JavaScript and WASM before the first smoke, kilobytes on the wire. */
const LIMITS = { wisp: 400, lamp: 900 };

test.describe('before the first smoke', () => {
  // The service worker loads more files later, which do not count here.
  test.use({ serviceWorkers: 'block' });

  for (const [preset, limit] of Object.entries(LIMITS)) {
    test(`${preset} fetches at most ${limit} kB of code`, async ({ page }) => {
      await page.goto(`${server.address}?paused=1#v=1&preset=${preset}`);
      const needed = (await fetchedFirst(page)).filter((file) => /\.(js|wasm)$/.test(file));
      const sent = server.sent.filter(({ file }) => needed.includes(file));
      expect(sent.reduce((sum, { bytes }) => sum + bytes, 0) / 1000).toBeLessThan(limit);
      // Optional files.
      const names = needed.join(' ');
      for (const rarity of ['GLTFLoader', 'OBJLoader', 'paper', 'draco']) expect(names).not.toContain(rarity);
      expect(names).not.toContain(preset === 'wisp' ? 'lamp-' : 'wisp-');
    });
  }
});

test('style sheets override the theme', () => {
  for (const name of ['index', 'paper', 'puff', 'examples']) {
    const sheets = readFileSync(join(folder, `${name}.html`), 'utf8').match(/<link rel="stylesheet"[^>]*>/g)!;
    expect(sheets.length, name).toBeGreaterThan(1);
    expect(sheets[0], name).toContain('/theme-');
  }
});

test('what the poster needs is small', () => {
  const page = readFileSync(join(folder, 'index.html'), 'utf8');
  const scripts = [...page.matchAll(/<(?:script type="module"|link rel="modulepreload")[^>]*"\.\/(assets[^"]+)/g)];
  const sizes = scripts.map(([, file]) => gzipSync(readFileSync(join(folder, file))).length);
  expect(sizes.reduce((sum, size) => sum + size, 0)).toBeLessThan(5000);
  expect(sizes.length).toBeLessThanOrEqual(4);
});

test('the poster is on the screen before files of the stage are fetched and WebGL is touched', async ({ page }) => {
  await page.addInitScript(() => {
    const { setTimeout, HTMLCanvasElement } = window;
    // The stage does not wait for a late poster.
    const isLate = (delay?: number) => delay === 1000;
    window.setTimeout = ((run: () => void, delay?: number) => !isLate(delay) && setTimeout(run, delay)) as never;
    const { getContext } = HTMLCanvasElement.prototype;
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, ...given: [string]) {
      performance.mark('context');
      return getContext.apply(this, given);
    } as never;
  });
  await page.goto(`${server.address}?paused=1${WISP}`);
  await page.waitForFunction(() => window.cartoonSmoke !== undefined);
  const [paint, context, ...later] = await page.evaluate(() => {
    const files = performance.getEntriesByType('resource').filter(({ name }) => /(stage|main|scene)-.+js$/.test(name));
    const marks = ['first-contentful-paint', 'context'].map((name) => performance.getEntriesByName(name)[0]);
    return [...marks, ...files].map(({ startTime }) => startTime);
  });
  expect(context).toBeGreaterThan(paint);
  expect(later.length).toBeGreaterThan(1);
  expect(Math.min(...later)).toBeGreaterThan(paint);
});

test.describe('offline', () => {
  test.use({ allowed: /ERR_CONNECTION_REFUSED/ });

  test('pages that were visited once work again', async ({ page }) => {
    await page.goto(`${server.address}${WISP}`);
    await isCached(page, 'bindings_bg');
    await server.close();
    await page.reload();
    await smokes(page);
  });
});

test('a new version is offered, takes over on request, and removes the old one @long', async ({ page }) => {
  await page.goto(`${server.address}${WISP}`);
  await isCached(page, 'index-');
  const [before, after] = renameEntry(folder);
  await page.reload();
  await page.evaluate(() => Object.assign(window, { isOld: true }));
  await page.getByRole('button', { name: 'Reload' }).click();
  await page.waitForFunction(() => !('isOld' in window));
  await smokes(page);
  await isCached(page, after);
  expect((await cached(page)).join(' ')).not.toContain(before);
  await expect(page.getByRole('button', { name: 'Reload' })).toBeHidden();
});

test('a new version that the browser found before the page is offered @long', async ({ page }) => {
  await page.goto(`${server.address}${WISP}`);
  await isCached(page, 'index-');
  renameEntry(folder);
  await page.addInitScript(() => {
    const register = navigator.serviceWorker.register.bind(navigator.serviceWorker);
    navigator.serviceWorker.register = async (...given) => {
      const registration = await register(...given);
      const found = new Promise((resolve) => registration.addEventListener('updatefound', resolve, { once: true }));
      void registration.update();
      if (!registration.installing && !registration.waiting) await found;
      return registration;
    };
  });
  await page.reload();
  await expect(page.getByRole('button', { name: 'Reload' })).toBeVisible();
});

/** Waits for smoke, also across a navigation. */
async function smokes(page: Page): Promise<void> {
  await page.waitForFunction(() => (window.cartoonSmoke?.stats.alive ?? 0) > 0);
}

/** The URLs that the page has loaded before its smoke, relative to its folder. Those of the controls follow at once. */
async function fetchedFirst(page: Page): Promise<string[]> {
  const list = await page.waitForFunction(() => {
    const base = new URL('.', location.href).href;
    return window.cartoonSmoke && performance.getEntriesByType('resource').map(({ name }) => name.slice(base.length));
  });
  return (await list.jsonValue())!;
}

async function isCached(page: Page, file: string): Promise<void> {
  await expect.poll(async () => (await cached(page)).join(' ')).toContain(file);
}

/** The files in the service worker's cache; empty during a reload. */
async function cached(page: Page): Promise<string[]> {
  const list = page.evaluate(async () => {
    const keys = await Promise.all((await caches.keys()).map(async (name) => (await caches.open(name)).keys()));
    return keys.flat().map(({ url }) => url);
  });
  return list.catch(() => []);
}

/** Publishes the site again with another name for the page's first script. */
function renameEntry(site: string): [before: string, after: string] {
  const before = readdirSync(join(site, 'assets')).find((name) => /^index-.+\.js$/.test(name))!;
  const after = 'index-Another1.js';
  renameSync(join(site, 'assets', before), join(site, 'assets', after));
  const naming = ['index.html', 'sw.js', ...readdirSync(join(site, 'assets')).map((name) => `assets/${name}`)];
  for (const name of naming.filter((each) => /\.(html|js)$/.test(each))) {
    const text = readFileSync(join(site, name), 'utf8');
    if (text.includes(before)) writeFileSync(join(site, name), text.replaceAll(before, after));
  }
  return [before, after];
}
