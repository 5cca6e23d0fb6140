import { AxeBuilder } from '@axe-core/playwright';
import type { Page } from '@playwright/test';
import { PNG } from 'pngjs';
import { expect, test } from '../../../support/fixtures.ts';
import { drop, expectValue, LIGHT, open, row, valueOf } from '../page.ts';

test.use({ viewport: { width: 900, height: 800 } });

const sheet = (page: Page) => page.getByRole('dialog', { name: 'Draw a puff' });
const tool = (page: Page, name: string) => sheet(page).getByRole('button', { name, exact: true });
const drawing = async (page: Page) => String(await valueOf(page, 'puff.drawing'));

async function openSheet(page: Page): Promise<void> {
  await open(page, `?paused=1&t=1${LIGHT}`);
  await page.locator('summary', { hasText: 'Shape of the puffs' }).click();
  await row(page, 'puff.drawing').getByRole('button', { name: 'Draw a puff' }).click();
  await expect(sheet(page)).toBeVisible();
}

/** Draws a line through points in units of the sheet. */
async function draw(page: Page, ...points: (readonly [x: number, y: number])[]): Promise<void> {
  const { x, y, width } = (await sheet(page).getByRole('application', { name: 'Sheet' }).boundingBox())!;
  const move = (point: readonly [number, number]) =>
    page.mouse.move(x + (point[0] / 256) * width, y + (point[1] / 256) * width);
  await move(points[0]);
  await page.mouse.down();
  for (const point of points.slice(1)) await move(point);
  await page.mouse.up();
}

/** The smoke as PNG data. */
const picture = (page: Page) =>
  page.evaluate(async () => {
    const bytes = new Uint8Array(await (await window.cartoonSmoke!.picture()).arrayBuffer());
    return bytes.reduce((sum, byte) => (31 * sum + byte) | 0, bytes.length);
  });

/** A PNG file with a red square in its middle. */
function redSquare(): Buffer {
  const png = new PNG({ width: 40, height: 40 });
  for (let at = 0; at < 1600; at++) {
    const isIn = [at % 40, Math.floor(at / 40)].every((place) => place >= 10 && place < 30);
    png.data.set(isIn ? [220, 30, 30, 255] : [0, 0, 0, 0], 4 * at);
  }
  return PNG.sync.write(png);
}

test('strokes of pointers and keys reach the smoke, and are undone', async ({ page }) => {
  await openSheet(page);
  const before = await picture(page);
  await draw(page, [60, 128], [200, 128], [128, 60]);
  await expect.poll(() => drawing(page)).toMatch(/^ffffff\*/);
  await expect.poll(() => picture(page)).not.toBe(before);
  const first = await drawing(page);
  await sheet(page)
    .getByRole('radio', { name: /^Colour 4/ })
    .check();
  await draw(page, [128, 110]);
  await expect.poll(() => drawing(page)).toContain('e2574c*');
  await page.keyboard.press('Control+z');
  await expectValue(page, 'puff.drawing', first);
  await page.keyboard.press('Control+Shift+z');
  await expect.poll(() => drawing(page)).toContain('e2574c*');
  await tool(page, 'Clear the sheet').click();
  await expectValue(page, 'puff.drawing', '');

  const paper = sheet(page).getByRole('application', { name: 'Sheet' });
  await paper.focus();
  await page.keyboard.down(' ');
  for (let step = 0; step < 4; step++) await page.keyboard.press('Shift+ArrowRight');
  await page.keyboard.up(' ');
  await expect.poll(() => drawing(page)).toMatch(/^e2574c\*/);
  await expect(sheet(page).getByRole('status')).toHaveText(/^Puff 1 of 1, pen, [5-9] % of the sheet painted\.$/);
  await tool(page, 'Pen').focus();
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Enter');
  await expect(tool(page, 'Eraser')).toHaveAttribute('aria-pressed', 'true');
  const { violations } = await new AxeBuilder({ page })
    .options({ resultTypes: ['violations'] })
    .setLegacyMode()
    .analyze();
  expect(violations.flatMap(({ id, nodes }) => nodes.map(({ target }) => `${id}: ${String(target)}`))).toEqual([]);

  await page.keyboard.press('Escape');
  await expect(sheet(page)).toBeHidden();
  await expect.poll(() => drawing(page)).toMatch(/^e2574c\*/);
  // All strokes of the session are one change of the page.
  await page.keyboard.press('Control+z');
  await expectValue(page, 'puff.drawing', '');
});

test('letters, pictures and SVG files become puffs, and hostile ones request nothing', async ({ page }) => {
  await openSheet(page);
  await sheet(page).getByRole('textbox', { name: 'Text' }).fill('POWER');
  await tool(page, 'Letters').click();
  await page.evaluate(() => {
    const end = performance.now() + 7000;
    while (performance.now() < end);
  });
  // The notice disappears after 6 s of running time. A busy page is not running time.
  await expect(page.getByText('Only the first 4 letters become puffs.')).toBeVisible();
  await expect(page.getByText('Only the first 4 letters become puffs.')).toBeHidden();
  await expect.poll(async () => (await drawing(page)).split(';')).toHaveLength(4);
  await tool(page, 'Puff 2').click();
  await expect(sheet(page).getByRole('status')).toHaveText(/^Puff 2 of 4/);

  const chooser = sheet(page).locator('input[type=file]');
  await chooser.setInputFiles({ name: 'square.png', mimeType: 'image/png', buffer: redSquare() });
  await expect.poll(async () => (await drawing(page)).split(';')[1]).toMatch(/^dc1e1e\*/);

  const requests: string[] = [];
  page.on('request', (request) => requests.push(request.url()));
  const hostile = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10" onload="document.title='hit'">
    <script>document.title = 'hit'</script><style>@import url(https://example.org/a.css);</style>
    <image href="https://example.org/a.png" width="9" height="9"/><use href="https://example.org/a.svg#a"/>
    <path d="M0 0 L9 9 L9 0 L0 9z" fill="#00ff00"/><path d="M0 0${' L1 1 L2 0'.repeat(500_000)}" fill="url(https://example.org/a)"/></svg>`;
  await chooser.setInputFiles({ name: 'hostile.svg', mimeType: 'image/svg+xml', buffer: Buffer.from(hostile) });
  await expect.poll(async () => (await drawing(page)).split(';')[1]).toContain('00ff00*');
  // The page fetches its own code.
  const own = new URL(page.url()).origin;
  expect(requests.filter((url) => !/^(data|blob):/.test(url) && new URL(url).origin !== own)).toEqual([]);
  expect(await page.title()).not.toBe('hit');

  const huge = redSquare();
  huge.writeUInt32BE(8193, 16);
  await chooser.setInputFiles({ name: 'huge.png', mimeType: 'image/png', buffer: huge });
  await expect(page.getByText('huge.png could not be opened. The picture is too large.')).toBeVisible();
  await chooser.setInputFiles({ name: 'torn.png', mimeType: 'image/png', buffer: Buffer.from('PNG') });
  await expect(page.getByText('torn.png could not be opened. It is not a valid PNG file.')).toBeVisible();
  expect((await drawing(page)).split(';')[1]).toContain('00ff00*');

  await tool(page, 'Cancel').click();
  await expectValue(page, 'puff.drawing', '');
});

test('a dropped picture asks what it is for', async ({ page }) => {
  await open(page, `?paused=1${LIGHT}`);
  const question = page.getByRole('dialog', { name: 'What is square.png for?' });
  await drop(page, 'square.png', redSquare());
  await expect(question.getByRole('button', { name: 'Puff sheet' })).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(question).toBeHidden();
  await expectValue(page, 'puff.drawing', '');
  await drop(page, 'square.png', redSquare());
  await question.getByRole('button', { name: 'Palette' }).click();
  await expect(page.getByText('square.png could not be opened. It has only one colour, #dc1e1e.')).toBeVisible();
  await drop(page, 'square.png', redSquare());
  await question.getByRole('button', { name: /^Puff Draws/ }).click();
  await expect(sheet(page)).toBeVisible();
  await expect.poll(() => drawing(page)).toMatch(/^dc1e1e\*/);
});
