/** The code for the element from the built site's share dialog, on a host page. */
import { createHash } from 'node:crypto';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Page } from '@playwright/test';
import { expect, test } from '../support/fixtures.ts';
import { serveOpenly, type SiteServer } from '../support/plainPage.ts';

const DIST = fileURLToPath(new URL('../../dist', import.meta.url));
const LOOK = '#v=2&preset=wisp&puff.variations=1&simulation.maxParticles=300&style.smokeColor=%23ff2010';

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

/** The content of the dialog's field for the element. */
async function snippet(page: Page): Promise<string> {
  await page.goto(`${server.address}?paused=1${LOOK}`);
  await page.getByRole('button', { name: 'Share' }).click();
  await page.getByText('Embed in your page').click();
  return page.getByLabel('Custom element with its script').inputValue();
}

/** Opens a page of another origin with only this code. */
async function paste(page: Page, code: string): Promise<void> {
  const head = '<!doctype html><meta charset="utf-8"><title>Elsewhere</title><link rel="icon" href="data:,">';
  writeFileSync(join(folder, 'index.html'), head + code);
  await page.goto(elsewhere.address);
}

test('pasted into an empty page of another origin it shows the smoke', async ({ page }) => {
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

/** Statistics of the element's stage. */
function statsOf(page: Page): Promise<{ bodiesDrawn: number }> {
  return page.locator('cartoon-smoke').evaluate((element) => Reflect.get(element, 'stats').call(element));
}
