/** The page of the site with the examples and their code. */
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { AxeBuilder } from '@axe-core/playwright';
import { expect, longIf, test } from '../../support/fixtures.ts';

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));
/** Pages that are no projects of their own. */
const PAGES = ['article', 'flipbook', 'landing'];
const files = execFileSync('git', ['ls-files', 'examples'], { cwd: ROOT, encoding: 'utf8' })
  .split('\n')
  .filter((path) => path.split('/').length > 2 && !PAGES.includes(path.split('/')[1]));
const projects = new Set(files.map((path) => path.split('/')[1]));

test.describe('with reduced motion', () => {
  // Nothing plays by itself.
  test.use({ contextOptions: { reducedMotion: 'reduce' } });

  for (const size of [
    { width: 1440, height: 900 },
    { width: 390, height: 844 },
  ]) {
    const tag = longIf(size.width > 390);
    test(`shows each project with its files, in a window of ${size.width} pixels${tag}`, async ({ page }) => {
      await page.setViewportSize(size);
      await page.goto('/examples.html');
      await expect(page.getByRole('region')).toHaveCount(projects.size);
      await expect(page.getByRole('radio')).toHaveCount(files.length);
      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(size.width);
      const { violations } = await new AxeBuilder({ page }).analyze();
      expect(violations.map(({ id }) => id)).toEqual([]);
    });
  }

  test('a keyboard selects a file, copies it, plays and stops', async ({ page, context }) => {
    await context.grantPermissions(['clipboard-read', 'clipboard-write']);
    await page.goto('/examples.html');
    const product = page.getByRole('region', { name: 'A product page' });
    const code = product.locator('code');
    await expect(code).toContainText("from 'cartoon-smoke/puff'");
    await product.getByRole('radio', { name: 'main.ts' }).focus();
    await page.keyboard.press('ArrowRight');
    const source = readFileSync(join(ROOT, 'examples/product/index.html'), 'utf8');
    await expect(code).toHaveText(source, { useInnerText: false });
    await page.keyboard.press('Tab');
    await page.keyboard.press('Enter');
    await expect(page.getByRole('status')).toHaveText('Copied.');
    expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(source);
    await expect(page.locator('iframe')).toHaveCount(0);
    await product.getByRole('button', { name: 'Play A product page' }).press('Enter');
    const button = product.frameLocator('iframe').getByRole('button', { name: 'Add to basket' });
    await expect(button).toBeVisible();
    await product.getByRole('button', { name: 'Stop A product page' }).press('Enter');
    await expect(page.locator('iframe')).toHaveCount(0);
  });
});

test('plays the example in the middle of the window, unless it is stopped', async ({ page }) => {
  await page.setViewportSize({ width: 900, height: 600 });
  await page.goto('/examples.html');
  const show = (name: string) =>
    page.getByRole('region', { name }).evaluate((element) => element.scrollIntoView({ block: 'center' }));
  await show('A product page');
  await expect(page.locator('iframe')).toHaveCount(1);
  const frame = page.frameLocator('iframe[title="A product page"]');
  await expect.poll(() => frame.locator('cartoon-smoke').evaluate((element) => element.matches(':defined'))).toBe(true);
  await show('Vue');
  const other = page.frameLocator('iframe[title="Vue"]');
  await expect(other.getByRole('slider')).toBeVisible();
  await expect(page.locator('iframe')).toHaveCount(1);
  await page.getByRole('button', { name: 'Stop Vue' }).click();
  await show('A product page');
  await expect(page.locator('iframe[title="A product page"]')).toHaveCount(1);
  await show('Vue');
  await expect(page.locator('iframe')).toHaveCount(0);
});
