/** The documentation in a nested folder of a host with a strict Content-Security-Policy. */
import { fileURLToPath } from 'node:url';
import { AxeBuilder } from '@axe-core/playwright';
import type { Page } from '@playwright/test';
import { presets } from '../../src/parameters/presets.ts';
import { expect, test } from '../support/fixtures.ts';
import { serveStrictly, type SiteServer } from '../support/plainPage.ts';

const DIST = fileURLToPath(new URL('../../dist', import.meta.url));
const PHONE = { width: 390, height: 844 };
const DESKTOP = { width: 1440, height: 900 };

let server: SiteServer;

test.beforeAll(async () => {
  server = await serveStrictly(DIST);
});
test.afterAll(() => server.close());
// A violation of the policy is an error on the console, which makes a test fail.
test.use({ serviceWorkers: 'block' });

/** Opens the search, whose button does nothing until the script of the page has run, and types. */
async function search(page: Page, words: string): Promise<void> {
  const box = page.getByRole('searchbox');
  await expect(async () => {
    if (!(await box.isVisible())) await page.getByRole('button', { name: 'Search' }).click();
    await expect(box).toBeFocused({ timeout: 5000 });
  }).toPass();
  await page.keyboard.type(words);
}

test('the search finds a section, whose page opens from this host alone', async ({ page }) => {
  const foreign: string[] = [];
  page.on('request', (request) => {
    if (!request.url().startsWith(server.address)) foreign.push(request.url());
  });
  await page.setViewportSize(DESKTOP);
  await page.goto(`${server.address}docs/design/puffs.html`);
  await search(page, 'wasm-unsafe-eval');
  await page.getByRole('listbox').getByRole('link', { name: 'Content Security Policy' }).first().click();
  await expect(page).toHaveURL(/\/docs\/[\w-]+\.html#content-security-policy$/);
  await expect(page.locator('#content-security-policy')).toBeInViewport();
  await page.getByRole('link', { name: 'Demo', exact: true }).click();
  await expect(page).toHaveURL(`${server.address}index.html`);
  expect(foreign).toEqual([]);
});

for (const colorScheme of ['light', 'dark'] as const) {
  for (const viewport of [DESKTOP, PHONE]) {
    test.describe(`${colorScheme}, ${viewport.width} pixels wide`, () => {
      test.use({ colorScheme, viewport });

      // The others differ by width or by colours alone.
      const often = colorScheme === 'light' && viewport === PHONE;
      test(`axe finds nothing, and nothing is wider than the window${often ? '' : ' @long'}`, async ({ page }) => {
        for (const name of often
          ? ['element', 'gallery', 'performance']
          : ['index', 'element', 'method', 'style', 'gallery', 'performance', 'design/performance']) {
          await page.goto(`${server.address}docs/${name}.html`);
          await expect(page.getByRole('heading', { level: 1 })).toBeVisible();
          const axe = new AxeBuilder({ page }).options({ resultTypes: ['violations'] }).setLegacyMode();
          const { violations } = await axe.analyze();
          const faults = violations.flatMap(({ id, nodes }) => nodes.map(({ target }) => `${id}: ${String(target)}`));
          expect(faults, name).toEqual([]);
          expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(viewport.width);
        }
      });
    });
  }
}

test('a live example starts when pressed, follows its attributes, and never evaluates them', async ({ page }) => {
  // It would start by itself.
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.setViewportSize(DESKTOP);
  await page.goto(`${server.address}docs/element.html#parameters`);
  const live = page.locator('.live').first();
  await expect(live.locator('.live-poster img')).toBeVisible();
  await live.getByRole('button', { name: 'Play', exact: true }).click();
  const smoke = live.locator('cartoon-smoke');
  await smoke.evaluate((element) => (element as HTMLElement & { ready: Promise<void> }).ready);
  await expect(smoke).toHaveAttribute('emission-rate', '24');
  const code = live.getByLabel('Edit the attributes');
  await code.fill('<cartoon-smoke preset="wisp" emission-rate="2000000" onclick="document.title = 1"></cartoon-smoke>');
  await expect(smoke).toHaveAttribute('emission-rate', '2000000');
  await expect(smoke).not.toHaveAttribute('onclick');
  await expect(smoke).not.toHaveAttribute('style-smoke-color');
  await expect(live.getByRole('status')).toContainText('emission.rate');
  await code.fill('<cartoon-smoke preset="wisp"><script>document.title = 1</script></cartoon-smoke>');
  await expect(live.getByRole('status')).toContainText('Write one <cartoon-smoke>');
  await live.getByRole('button', { name: 'Reset' }).click();
  await expect(smoke).toHaveAttribute('emission-rate', '24');
  await expect(live.getByRole('status')).toBeEmpty();
});

test('a figure of the method shows a debug view of the demo, and another one when chosen', async ({ page }) => {
  await page.setViewportSize(DESKTOP);
  await page.goto(`${server.address}docs/method.html`);
  const figure = page.locator('.live').first();
  await figure.getByRole('button', { name: 'Show depth' }).click();
  const demo = await (await figure.locator('iframe').elementHandle())?.contentFrame();
  await demo!.waitForFunction(() => window.cartoonSmoke?.view === 'depth');
  await figure.getByRole('radio', { name: 'Ink' }).check();
  await demo!.waitForFunction(() => window.cartoonSmoke?.view === 'ink');
  await figure.getByRole('radio', { name: 'Picture' }).check();
  await demo!.waitForFunction(() => window.cartoonSmoke?.view === undefined);
});

test('the gallery has every preset with its picture, code and link', async ({ page }) => {
  await page.goto(`${server.address}docs/gallery.html`);
  const cards = page.locator('.presets article');
  await expect(cards).toHaveCount(presets.length);
  for (const { name } of presets) {
    const card = cards.filter({ has: page.getByText(name, { exact: true }) });
    await expect(card.getByRole('link').first()).toHaveAttribute('href', `../index.html#v=1&preset=${name}`);
    await expect(card.locator('pre')).toContainText([`preset="${name}"`, `preset: '${name}'`]);
  }
  const picture = cards.last().locator('img');
  await picture.scrollIntoViewIfNeeded();
  await expect.poll(() => picture.evaluate((image: HTMLImageElement) => image.naturalWidth)).toBe(192);
});

test.describe('without JavaScript', () => {
  test.use({ javaScriptEnabled: false, viewport: DESKTOP });

  test('pages have their text, their code and their navigation', async ({ page }) => {
    await page.goto(`${server.address}docs/design/puffs.html`);
    await page.getByRole('link', { name: 'The element', exact: true }).click();
    await expect(page.getByRole('heading', { name: 'Installation' })).toBeVisible();
    await expect(page.getByText("import 'cartoon-smoke/element';").first()).toBeVisible();
  });
});

test.describe('offline', () => {
  test.use({ serviceWorkers: 'allow', allowed: /ERR_CONNECTION_REFUSED|ERR_FAILED/, viewport: DESKTOP });

  test('the search finds pages that were not visited', async ({ page }) => {
    const own = await serveStrictly(DIST);
    await page.goto(`${own.address}docs/index.html`);
    await expect
      .poll(() =>
        page.evaluate(async () => {
          const names = await caches.keys();
          const lists = await Promise.all(names.map(async (name) => (await caches.open(name)).keys()));
          return lists.flat().filter(({ url }) => /glossary\.html|glossary\.md|localSearchIndex/.test(url)).length;
        }),
      )
      .toBeGreaterThanOrEqual(4);
    await own.close();
    await page.reload();
    await search(page, 'nailboard');
    await page.getByRole('listbox').getByRole('link', { name: 'Glossary' }).first().click();
    await expect(page.getByRole('heading', { name: 'Glossary', level: 1 })).toBeVisible();
    await page.reload();
    await expect(page.getByRole('heading', { name: 'Glossary', level: 1 })).toBeVisible();
  });
});
