/** The whole page with a strict Content-Security-Policy: no user action violates it. */
import { fileURLToPath } from 'node:url';
import type { Page } from '@playwright/test';
import { closeSheet, expectSteps, isComplete } from '../e2e/demo/page.ts';
import { expect, test } from '../support/fixtures.ts';
import { serveStrictly, type SiteServer } from '../support/plainPage.ts';

const DIST = fileURLToPath(new URL('../../dist', import.meta.url));
const LIGHT = '#v=1&preset=lamp&emission.rate=40&puff.variations=1&simulation.maxParticles=500';

let server: SiteServer;

test.beforeAll(async () => {
  server = await serveStrictly(DIST);
});
test.afterAll(() => server.close());
// Each test provokes one violation at its end.
test.use({ serviceWorkers: 'block', allowed: /Applying inline style violates/ });

test.beforeEach(async ({ page }) => {
  await page.setViewportSize({ width: 760, height: 540 });
  await page.addInitScript(() => {
    const violations: string[] = [];
    Object.assign(window, { violations });
    addEventListener('securitypolicyviolation', ({ violatedDirective, blockedURI, sourceFile, lineNumber }) =>
      violations.push(`${violatedDirective} ${blockedURI} ${sourceFile}:${lineNumber}`),
    );
  });
});
test.afterEach(async ({ page }) => {
  const violations = () => page.evaluate(() => (window as unknown as { violations: string[] }).violations);
  expect(await violations()).toEqual([]);
  // The absence of violations is only meaningful if a violation would be detected.
  await page.evaluate(() => document.body.setAttribute('style', 'color: red'));
  await expect.poll(violations).toHaveLength(1);
});

test('panel, gallery, handles, statistics, views and notices', async ({ page }) => {
  await open(page, `?paused=1&stats=1${LIGHT}&nonsense=1&emission.rate=1e9`);
  await page.getByLabel('Puff size, exact value').fill('2');
  for (const title of await page.locator('details > summary').filter({ visible: true }).all()) await title.click();
  await page.keyboard.press('/');
  await page.keyboard.type('wind');
  await page.locator('#smoke').focus();
  await page.keyboard.press('h');
  await page.getByRole('button', { name: 'Add a vortex' }).click();
  await page.keyboard.press('v');
  await page.keyboard.press('?');
  await closeSheet(page);
  // The gallery is collapsed in a window of this height.
  await page.keyboard.press('g');
  await page.getByRole('radio', { name: 'Cup of tea' }).check();
  await expect.poll(() => page.evaluate(() => window.cartoonSmoke!.get().scene)).toBe('wisp');
});

test('sheets for sharing and capture, files and own presets @long', async ({ page }) => {
  await open(page, `?paused=1&t=0.5${LIGHT}`);
  await expectSteps(page, 30);
  await page.getByRole('button', { name: 'Save this look' }).click();
  await expect(page.locator('.own-cards li')).toHaveCount(1);
  await page.keyboard.press('s');
  await expect(page.getByRole('img', { name: 'QR code of the link' })).toBeVisible();
  await savesFile(page, 'Save as file', /\.json$/);
  await closeSheet(page);
  await page.keyboard.press('c');
  await page.getByRole('combobox', { name: 'Size' }).selectOption('640x360');
  await savesFile(page, 'Capture', /^lamp-0\.50s\.png$/);
  await expect(page.getByText(/^Saved lamp-0\.50s\.png/)).toBeVisible();
  // Encoded in a worker.
  await page.getByRole('combobox', { name: 'Format' }).selectOption('apng');
  await page.getByRole('spinbutton', { name: 'Seconds' }).fill('0.1');
  await savesFile(page, 'Capture', /^lamp-0\.50s\.apng$/);
});

async function open(page: Page, address: string): Promise<void> {
  await page.goto(server.address + address);
  await isComplete(page);
}

async function savesFile(page: Page, button: string, name: RegExp): Promise<void> {
  const dialog = page.getByRole('dialog').filter({ visible: true });
  const [file] = await Promise.all([
    page.waitForEvent('download'),
    dialog.getByRole('button', { name: button, exact: true }).click(),
  ]);
  expect(file.suggestedFilename()).toMatch(name);
}
