/** Code from the built site's share dialog, on host pages. */
import { createHash } from 'node:crypto';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Locator, Page } from '@playwright/test';
import { PNG } from 'pngjs';
import type { Values } from '../../src/parameters/parameter.ts';
import type { CartoonSmoke } from '../../src/three/cartoonSmoke.ts';
import { expect, test } from '../support/fixtures.ts';
import { serveOpenly, type SiteServer } from '../support/plainPage.ts';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const DIST = fileURLToPath(new URL('../../dist', import.meta.url));
const LOOK = '#v=1&preset=wisp&puff.variations=1&simulation.maxParticles=300&style.smokeColor=%23ff2010';

let server: SiteServer;
/** Another origin, because the port differs. */
let elsewhere: SiteServer;
const folder = mkdtempSync(join(tmpdir(), 'cartoon-smoke-elsewhere-'));

test.use({ serviceWorkers: 'block', viewport: { width: 640, height: 480 } });
test.beforeAll(async () => {
  server = await serveOpenly(DIST);
  elsewhere = await serveOpenly(folder);
});
test.afterAll(async () => {
  await server.close();
  await elsewhere.close();
  rmSync(folder, { recursive: true });
});

/** Opens the embed builder of a page. @param moment simulated seconds before the first picture, which the code has too */
async function openBuilder(page: Page, moment?: number): Promise<void> {
  await page.goto(`${server.address}?paused=1${moment === undefined ? '' : `&t=${moment}`}${LOOK}`);
  await page.getByRole('button', { name: 'Share' }).click();
  if (moment !== undefined) {
    await expect.poll(() => page.evaluate(() => window.cartoonSmoke!.stats.steps)).toBe(60 * moment);
    await page.getByRole('radio', { name: 'This moment' }).check();
  }
  await page.getByText('Embed in your page').click();
}

/** The code of the builder. */
async function codeFor(page: Page, kind: string): Promise<string> {
  await page.getByRole('radio', { name: kind, exact: true }).check();
  const field = page.getByLabel('Code', { exact: true });
  const start = { 'Custom element': /^<script/, Iframe: /^<iframe/, 'three.js': /^import/ }[kind]!;
  await expect(field).toHaveValue(start);
  return field.inputValue();
}

async function snippet(page: Page): Promise<string> {
  await openBuilder(page);
  return codeFor(page, 'Custom element');
}

let pages = 0;

/** Opens a page of another origin with only this code. */
async function paste(page: Page, code: string): Promise<void> {
  const head = '<!doctype html><meta charset="utf-8"><title>Elsewhere</title><link rel="icon" href="data:,">';
  writeFileSync(join(folder, 'index.html'), head + code);
  await page.goto(`${elsewhere.address}?${++pages}`);
}

test('pasted into an empty page of another origin it shows the smoke @long', async ({ page }) => {
  const code = await snippet(page);
  const [, address, integrity] = /^<script type="module" src="([^"]+)" integrity="([^"]+)" crossorigin/.exec(code)!;
  expect(address).toMatch(/^http:.+\/some\/where\/element\/\w{12}\/cartoon-smoke\.min\.js$/);
  const bytes = await (await page.request.get(address)).body();
  expect(integrity).toBe(`sha384-${createHash('sha384').update(bytes).digest('base64')}`);

  await paste(page, code);
  const smoke = page.locator('cartoon-smoke');
  await expect.poll(() => smoke.evaluate((element) => element.matches(':defined'))).toBe(true);
  await expect.poll(async () => (await statsOf(page)).bodiesDrawn).toBeGreaterThan(0);
  expect(await smoke.evaluate((element) => Reflect.get(element, 'get').call(element))).toMatchObject({
    'style.smokeColor': '#ff2010',
  });
});

test.describe('modified in transit', () => {
  test.use({ allowed: /integrity|ERR_FAILED/ });

  test('the script does not run', async ({ page }) => {
    const code = await snippet(page);
    await page.route('**/cartoon-smoke.min.js', async (route) => {
      const response = await route.fetch();
      await route.fulfill({ response, body: `${await response.text()}\nwindow.isChanged = true;` });
    });
    const rejected = page.waitForEvent('console', (message) => message.text().includes('integrity'));
    await paste(page, code);
    await rejected;
    expect(await page.evaluate(() => ['isChanged' in window, customElements.get('cartoon-smoke')])).toEqual([
      false,
      undefined,
    ]);
  });
});

test('element and iframe show the same moment as the page, with the chosen options @long', async ({ page }) => {
  await openBuilder(page, 0.5);
  const hash = await page.evaluate(() => window.cartoonSmoke!.hash());
  await page.getByLabel('Width, px').fill('320');
  await page.getByLabel('Ratio').selectOption('4:3');
  for (const name of ['Transparent', 'Interactive', 'Poster']) await page.getByLabel(name, { exact: true }).check();
  await page.getByLabel('Description for screen readers').fill('"Steam" & <b>more</b>');
  const [poster] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Download poster' }).click(),
  ]);
  const picture = PNG.sync.read(readFileSync(await poster.path()));
  expect([poster.suggestedFilename(), picture.width, picture.height]).toEqual(['smoke.png', 640, 480]);
  expect(picture.data[3], 'the corner is transparent').toBe(0);
  expect(picture.data.some((byte, at) => at % 4 === 3 && byte === 255)).toBe(true);
  await page.getByRole('button', { name: 'Copy code' }).focus();
  const [element, frame] = [await codeFor(page, 'Custom element'), await codeFor(page, 'Iframe')];

  await poster.saveAs(join(folder, 'smoke.png'));
  await paste(page, element);
  const smoke = page.locator('cartoon-smoke');
  await expect.poll(() => hashOf(smoke)).toBe(hash);
  expect(await smoke.evaluate(flagsOf)).toEqual([true, true, '"Steam" & <b>more</b>', 320, 240]);
  await expect(page.locator('img')).toHaveJSProperty('naturalWidth', 640);

  await paste(page, frame);
  const inside = page.frameLocator('iframe').locator('cartoon-smoke');
  await expect.poll(() => hashOf(inside)).toBe(hash);
  expect(await inside.evaluate(flagsOf)).toEqual([true, true, null, 320, 240]);
  await expect(page.locator('iframe')).toHaveAttribute('title', '"Steam" & <b>more</b>');
});

test('the code for three.js has the same smoke after as many steps @long', async ({ page, context }) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await openBuilder(page, 0.5);
  const hash = await page.evaluate(() => window.cartoonSmoke!.hash());
  const values = await page.evaluate(() => window.cartoonSmoke!.get());
  await page.getByLabel('Width, px').fill('320');
  await page.getByLabel('Description for screen readers').fill("It's </script> smoke");
  const note = page.getByText('The code has only the smoke. The objects of this scene are not in it.', { exact: true });
  await expect(note).toHaveCount(0);
  const code = await codeFor(page, 'three.js');
  await expect(note).toBeVisible();
  await page.getByRole('button', { name: 'Copy code' }).click();
  await expect(page.getByRole('status').filter({ hasText: 'Code copied.' })).toBeVisible();
  expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(code);

  const repository = await serveOpenly(ROOT);
  const from = (path: string) => `"${repository.address}${path}"`;
  const three = from('node_modules/three/build/three.module.js');
  const map = `{ "imports": { "three": ${three}, "cartoon-smoke": ${from('package/dist/index.js')} } }`;
  const shown = 'renderer.setAnimationLoop(null); window.smoke = smoke;';
  await paste(page, `<body><script type="importmap">${map}</script><script type="module">${code}\n${shown}</script>`);
  await page.waitForFunction(() => 'smoke' in window);
  const other = await page.evaluate(() => {
    const smoke = Reflect.get(window, 'smoke') as CartoonSmoke;
    smoke.step(30 - smoke.stats.steps);
    return { hash: smoke.hash(), values: smoke.get() };
  });
  expect(other.hash).toBe(hash);
  const look = (all: Values) => Object.fromEntries(Object.entries(all).filter(([key]) => /^(puff|emission)/.test(key)));
  expect(look(other.values)).toEqual(look(values));
  expect(other.values['style.smokeColor']).toBe('#ff2010');
  await expect(page.getByRole('img', { name: "It's </script> smoke" })).toHaveCSS('width', '320px');
  await repository.close();
});

/** The hash of an element when it is ready, and nothing before. */
function hashOf(smoke: Locator): Promise<string | undefined> {
  return smoke.evaluate(async (element) => {
    const isReady = await Promise.race([
      Reflect.get(element, 'ready'),
      new Promise((end) => setTimeout(end, 100, 'late')),
    ]);
    return isReady === undefined && element.matches(':defined')
      ? Reflect.get(element, 'hash').call(element)
      : undefined;
  });
}

/** Runs in the page: options of an element, and the size of its picture. */
function flagsOf(smoke: Element): unknown[] {
  const { width, height } = smoke.getBoundingClientRect();
  return [
    smoke.hasAttribute('transparent'),
    smoke.hasAttribute('interactive'),
    smoke.getAttribute('alt'),
    width,
    height,
  ];
}

/** Statistics of the element's stage. */
function statsOf(page: Page): Promise<{ bodiesDrawn: number }> {
  return page.locator('cartoon-smoke').evaluate((element) => Reflect.get(element, 'stats').call(element));
}
