import { expect, test } from '../../../support/fixtures.ts';
import { expectValue, LIGHT, open, row, valueOf } from '../page.ts';

const KEY = 'shapes.0.outline';
const svg = (content: string) =>
  Buffer.from(`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100">${content}</svg>`);

test('the outline of a shape is a word, an SVG file or none, and can be undone', async ({ page }) => {
  await open(page, `?paused=1${LIGHT}`);
  await page.keyboard.press('p');
  await page.getByLabel('What to add').selectOption('shapes');
  await page.getByRole('button', { name: 'Add', exact: true }).click();
  await expect.poll(() => page.evaluate(() => decodeURIComponent(location.hash))).toContain(`${KEY}=`);
  const control = row(page, KEY);
  await control.scrollIntoViewIfNeeded();
  const first = await valueOf(page, KEY);

  const word = control.getByPlaceholder('Type a word');
  await word.fill('TEA');
  await word.press('Enter');
  await expect.poll(async () => String(await valueOf(page, KEY)).split('.').length).toBe(4);
  await expect(control.locator('.outline-shape')).toHaveAttribute('d', /^(M[^MZ]+Z){4}$/);
  await page.getByRole('button', { name: 'Undo' }).click();
  await expectValue(page, KEY, first);

  const files = control.locator('input[type=file]');
  await files.setInputFiles({ name: 'a.svg', mimeType: 'image/svg+xml', buffer: svg('<path d="M0 0h90v90h-90z"/>') });
  await expect.poll(async () => String(await valueOf(page, KEY)).split('.').length).toBe(1);
  await expect.poll(() => valueOf(page, KEY)).not.toBe(first);
  const traced = await valueOf(page, KEY);
  await files.setInputFiles({ name: 'b.svg', mimeType: 'image/svg+xml', buffer: svg('<script>hacked = 1</script>') });
  await expect(control.getByRole('alert')).toContainText('no shapes');
  await expectValue(page, KEY, traced);

  await control.getByRole('button', { name: 'Remove the outline' }).click();
  await expectValue(page, KEY, '');
  await expect(control.getByRole('button', { name: 'Remove the outline' })).toBeDisabled();
});
