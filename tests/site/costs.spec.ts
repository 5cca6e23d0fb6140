/** The measurement of the visitor's machine in the documentation, in a nested folder with a strict policy. */
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import type { Frame, Page } from '@playwright/test';
import { CASES } from '../../src/demo/costs/cases.ts';
import { expect, test } from '../support/fixtures.ts';
import { serveStrictly, type SiteServer } from '../support/plainPage.ts';

const DIST = fileURLToPath(new URL('../../dist', import.meta.url));
const LONG_MS = 500_000;

let server: SiteServer;

test.beforeAll(async () => {
  server = await serveStrictly(DIST);
});
test.afterAll(() => server.close());
test.use({ serviceWorkers: 'block', viewport: { width: 1440, height: 900 } });

async function open(page: Page): Promise<void> {
  await page.goto(`${server.address}docs/performance.html`);
  await page.getByLabel('Rounds').selectOption('1');
}

const start = (page: Page) => page.getByRole('button', { name: 'Measure this machine' });
const status = (page: Page) => page.locator('.measure-status');

test('a press measures this machine, and gives a table to copy and to download @long', async ({ page, context }) => {
  const foreign: string[] = [];
  page.on('request', (request) => {
    if (!/^(blob|data):/.test(request.url()) && !request.url().startsWith(server.address)) foreign.push(request.url());
  });
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await open(page);
  await expect(page.locator('iframe')).toHaveCount(0);
  await start(page).click();
  await expect(status(page)).toHaveText('Done.', { timeout: LONG_MS });

  const text = await page.getByLabel('The table as Markdown').inputValue();
  const lines = text.split('\n');
  const table = lines.filter((line) => line.startsWith('|'));
  expect(lines[0]).toMatch(/SwiftShader.*, Chrome \d+, 320 x 180 CSS pixels, rounds: 1$/);
  const [head, , ...rows] = table.map((line) => line.slice(2, -2).split(' | '));
  expect(rows.map(([name]) => name)).toEqual(['2,000 puffs', ...CASES.map(({ name }) => name)]);
  for (const [name, ...cells] of rows) {
    expect(cells, name).toHaveLength(head.length - 1);
    for (const cell of cells) {
      expect(Number.isFinite(Number(cell)), `${name}: ${cell}`).toBe(true);
      expect(Number(cell), name).toBeGreaterThan(0);
    }
  }
  const passes = [...text.matchAll(/(scene|puffs|shadow volumes|passes over the picture) ([\d.]+) ms/g)];
  expect(passes.map(([, name]) => name).toSorted()).toEqual([
    'passes over the picture',
    'puffs',
    'scene',
    'shadow volumes',
  ]);
  for (const [, name, milliseconds] of passes) expect(Number(milliseconds), name).toBeGreaterThan(0);
  await expect(page.locator('.measure-table tbody tr')).toHaveCount(rows.length);
  await expect(page.locator('iframe')).toHaveCount(0);

  await page.getByRole('button', { name: 'Copy', exact: true }).click();
  await expect(status(page)).toHaveText('Copied.');
  expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(text);
  await page.evaluate(() => Object.defineProperty(navigator, 'clipboard', { value: undefined }));
  await page.getByRole('button', { name: 'Copy', exact: true }).click();
  await expect(status(page)).toContainText('copy it with the keyboard');
  expect(await page.evaluate(() => String(getSelection()))).toBe(text);
  const saved = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Download' }).click();
  expect(readFileSync(await (await saved).path(), 'utf8')).toBe(text);
  expect(foreign).toEqual([]);
});

test('a measurement can be cancelled, and started again', async ({ page }) => {
  await open(page);
  await start(page).click();
  await expect(status(page)).toContainText('Measuring', { timeout: LONG_MS });
  for (const again of [false, true]) {
    if (again) await start(page).click();
    await page.getByRole('button', { name: 'Cancel' }).click();
    await expect(status(page)).toHaveText('Cancelled.');
    await expect(page.locator('iframe')).toHaveCount(0);
    await expect(page.locator('.measure-table')).toHaveCount(0);
  }
});

/** Waits for the measurement to begin. @returns its frame */
async function measuring(page: Page): Promise<Frame> {
  await open(page);
  await start(page).click();
  await expect(status(page)).toContainText('Measuring', { timeout: LONG_MS });
  return page.frame({ url: /\/costs\.html$/ })!;
}

test('a hidden page measures nothing, and a visible one continues @long', async ({ page }) => {
  const frame = await measuring(page);
  await frame.evaluate(() => {
    const { requestAnimationFrame } = window;
    const state = Object.assign(window, { counted: 0, isHidden: true });
    window.requestAnimationFrame = (work) => {
      state.counted++;
      return requestAnimationFrame(work);
    };
    Object.defineProperty(document, 'hidden', { get: () => state.isHidden });
    document.dispatchEvent(new Event('visibilitychange'));
  });
  const frames = () => frame.evaluate(() => Reflect.get(window, 'counted') as number);
  const name = await status(page).textContent();
  // Until the work that had begun has ended.
  await expect(async () => {
    const before = await frames();
    await page.evaluate(async () => {
      for (let left = 60; left > 0; left--) await new Promise(requestAnimationFrame);
    });
    expect(await frames()).toBe(before);
  }).toPass();
  await expect(status(page)).toHaveText(name!);
  await frame.evaluate(() => {
    Object.assign(window, { isHidden: false });
    document.dispatchEvent(new Event('visibilitychange'));
  });
  await expect(status(page)).not.toHaveText(name!);
  await expect(status(page)).toContainText('Measuring');
});

const FAILURES = [
  {
    name: 'without WebGL 2',
    text: 'This browser has no WebGL 2',
    prepare: (page: Page) =>
      page.addInitScript(() => {
        HTMLCanvasElement.prototype.getContext = () => null;
      }),
  },
  {
    name: 'without its page',
    text: 'could not be loaded',
    prepare: (page: Page) => page.route('**/costs.html', (route) => route.abort()),
  },
  {
    name: 'without its script',
    text: 'could not be loaded',
    prepare: (page: Page) => page.route('**/assets/costs-*.js', (route) => route.abort()),
  },
];

test.describe('failures', () => {
  test.use({ allowed: /ERR_FAILED|Context Lost|CONTEXT_LOST/ });

  test('with a lost context there is a sentence and no table', async ({ page }) => {
    const frame = await measuring(page);
    await frame.evaluate(() =>
      document.querySelector('canvas')!.getContext('webgl2')!.getExtension('WEBGL_lose_context')!.loseContext(),
    );
    await expect(status(page)).toContainText('took the graphics context away');
    await expect(page.locator('.measure-table, iframe')).toHaveCount(0);
    await expect(start(page)).toBeEnabled();
  });

  for (const { name, text, prepare } of FAILURES) {
    test(`${name} there is a sentence and no table`, async ({ page }) => {
      await prepare(page);
      await open(page);
      await start(page).click();
      await expect(status(page)).toContainText(text, { timeout: 60_000 });
      await expect(page.locator('.measure-table')).toHaveCount(0);
      await expect(start(page)).toBeEnabled();
    });
  }
});
