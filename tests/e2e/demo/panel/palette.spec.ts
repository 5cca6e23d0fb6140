/** Looks from palettes and pictures. */
import { AxeBuilder } from '@axe-core/playwright';
import type { Page } from '@playwright/test';
import { PNG } from 'pngjs';
import { aseOf } from '../../../support/files/ase.ts';
import { expect, test } from '../../../support/fixtures.ts';
import { ask, closeSheet, drop, expectValue, LIGHT, open, row, valueOf } from '../page.ts';

test.use({ viewport: { width: 900, height: 800 } });

const dialog = (page: Page) => page.getByRole('dialog', { name: 'Choose a look' });
const card = (page: Page, name: string) => dialog(page).getByRole('button', { name });
const valuesOf = (page: Page) => ask(page, (stage) => stage.get());
/** The colours of the file in the open dialog, from dark to light. */
const source = (page: Page) =>
  dialog(page)
    .locator('.looks-source rect')
    .evaluateAll((all) => all.map((each) => each.getAttribute('fill')));

const COLORS = ['#2d1b33', '#a33b5c', '#e8684a', '#ffe0a3'];
const CHANNELS = ['45 27 51', '163 59 92', '232 104 74', '255 224 163'];
const digits = COLORS.map((color) => color.slice(1));
const gpl = `GIMP Palette\nName: Sunset\n#\n${CHANNELS.join('\n')}\n`;
const swatches = CHANNELS.map((text) => {
  const values = text.split(' ').map((channel) => Number(channel) / 255);
  return { name: text, model: 'RGB ', values };
});

/** A PNG of equal stripes of the colours. */
function stripes(): Buffer {
  const png = new PNG({ width: 64, height: 16 });
  for (let at = 0; at < 64 * 16; at++) {
    png.data.set([...CHANNELS[Math.floor((at % 64) / 16)].split(' ').map(Number), 255], 4 * at);
  }
  return PNG.sync.write(png);
}

/** A picture in another format, with the stripes of the PNG. */
async function encoded(page: Page, type: string): Promise<Buffer> {
  const base64 = await page.evaluate(
    async ([data, format]) => {
      const bytes = Uint8Array.from(atob(data), (each) => each.charCodeAt(0));
      const bitmap = await createImageBitmap(new Blob([bytes]));
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
      canvas.getContext('2d')!.drawImage(bitmap, 0, 0);
      const blob = await canvas.convertToBlob({ type: format, quality: 1 });
      return btoa(String.fromCharCode(...new Uint8Array(await blob.arrayBuffer())));
    },
    [stripes().toString('base64'), type],
  );
  return Buffer.from(base64, 'base64');
}

test('palettes in every format propose looks in their colours, and Escape changes nothing', async ({ page }) => {
  await open(page, `?paused=1${LIGHT}`);
  const before = await valuesOf(page);
  const formats: [name: string, content: Uint8Array | string][] = [
    ['sunset.gpl', gpl],
    ['sunset.hex', digits.join('\n')],
    ['sunset.txt', `; paint.net Palette File\n${digits.map((color) => `FF${color}`).join('\n')}`],
    ['sunset.pal', `JASC-PAL\r\n0100\r\n4\r\n${CHANNELS.join('\r\n')}\r\n`],
    ['sunset.json', JSON.stringify({ name: 'Sunset', author: '', colors: digits })],
    ['SUNSET.ASE', aseOf(['group', ...swatches, 'end'])],
  ];
  for (const [name, content] of formats) {
    await drop(page, name, content);
    await expect(dialog(page).getByText(`${name}: 4 colours`)).toBeVisible();
    expect(await source(page), name).toEqual(COLORS);
    await expect(dialog(page).getByRole('button')).toHaveCount(4);
    await closeSheet(page);
  }
  expect(await valuesOf(page)).toEqual(before);
});

test('pictures do so, too, after a question where they have other uses', async ({ page }) => {
  await open(page, `?paused=1${LIGHT}`);
  await drop(page, 'stripes.png', stripes());
  await page.getByRole('dialog', { name: 'What is stripes.png for?' }).getByRole('button', { name: 'Palette' }).click();
  await expect(dialog(page).getByText('stripes.png: 4 colours')).toBeVisible();
  expect(await source(page)).toEqual(COLORS);
  await closeSheet(page);

  await drop(page, 'stripes.webp', await encoded(page, 'image/webp'));
  await expect(dialog(page).getByText('stripes.webp: 4 colours')).toBeVisible();
  await closeSheet(page);
  await drop(page, 'stripes.jpg', await encoded(page, 'image/jpeg'));
  await expect(dialog(page).getByText(/^stripes\.jpg: [4-6] colours$/)).toBeVisible();
  await closeSheet(page);

  const bars = COLORS.map((fill, at) => `<rect x="${9 * at}" width="9" height="9" fill="${fill}"/>`).join('');
  await drop(page, 'stripes.svg', `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 36 9">${bars}</svg>`);
  await page.getByRole('dialog', { name: 'What is stripes.svg for?' }).getByRole('button', { name: 'Palette' }).click();
  await expect(dialog(page).getByText('stripes.svg: 4 colours')).toBeVisible();
  expect(await source(page)).toEqual(COLORS);
});

test.describe('in full resolution', () => {
  test.use({ deviceScaleFactor: 1 });

  test('a look is chosen with the keyboard as one change, and its picture is the smoke of the page @long', async ({
    page,
  }) => {
    const fetched: string[] = [];
    page.on('request', (request) => fetched.push(request.url()));
    await open(page, `?t=3${LIGHT}&light.color=ff0000&style.gradient=height`);
    const before = await valuesOf(page);
    const isLoaded = () => fetched.some((url) => url.includes('lookDialog'));
    expect(isLoaded()).toBe(false);
    await expect.poll(() => ask(page, (stage) => stage.playing)).toBe(true);
    await drop(page, 'sunset.gpl', gpl);
    await expect(dialog(page)).toBeVisible();
    expect(isLoaded()).toBe(true);
    expect(await ask(page, (stage) => stage.playing)).toBe(false);

    // Each preview has the colours of its look: the backdrop in a corner, the smoke somewhere.
    const canvases = dialog(page).locator('canvas');
    for (const at of [0, 1, 2]) await expect(canvases.nth(at)).toBeVisible();
    const pictures = await canvases.evaluateAll((all) =>
      (all as HTMLCanvasElement[]).map((canvas) => {
        const { data } = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height);
        const colors = new Set<string>();
        for (let pixel = 0; pixel < data.length; pixel += 4) colors.add([...data.subarray(pixel, pixel + 3)].join(' '));
        return { corner: [...data.subarray(0, 3)].join(' '), colors: [...colors] };
      }),
    );
    const poster = pictures[1];
    expect(poster.corner).toBe(CHANNELS[2]);
    for (const color of [CHANNELS[0], CHANNELS[3]]) expect(poster.colors).toContain(color);
    expect(new Set(pictures.map(({ corner }) => corner)).size).toBe(3);
    expect(await valuesOf(page)).toEqual(before);

    await expect(card(page, 'Full range')).toBeFocused();
    await page.keyboard.press('Tab');
    await expect(card(page, 'Poster')).toBeFocused();
    await page.keyboard.press('Enter');
    await expect(dialog(page)).toHaveCount(0);
    await expectValue(page, 'style.inkColor', COLORS[0]);
    await expectValue(page, 'style.backdrop', '0:e8684a,1:e8684a');
    await expectValue(page, 'light.color', '#ffffff');
    expect(String(await valueOf(page, 'style.ramp'))).toMatch(/^0:[0-9a-f]{6},\.5:ffe0a3$/);
    expect(await ask(page, (stage) => stage.playing)).toBe(true);
    await expect(page.getByText('The look is “Poster” from sunset.gpl.')).toBeVisible();
    await page.keyboard.press('Control+z');
    await expect.poll(() => valuesOf(page)).toEqual(before);
    await page.keyboard.press('Control+Shift+z');
    await expectValue(page, 'style.inkColor', COLORS[0]);
  });
});

test('what is no palette is rejected with a message, and other files open as before', async ({ page }) => {
  await open(page, `?paused=1${LIGHT}`);
  const before = await valuesOf(page);
  const torn = aseOf(swatches).slice(0, -1);
  for (const [name, content, message] of [
    ['empty.gpl', '', 'It is empty.'],
    ['diary.txt', 'Dear diary', 'It is not a palette. Use .gpl (GIMP)'],
    ['torn.ase', torn, 'It ends in block 4 of 4.'],
    ['one.hex', 'ff8800', 'It has only one colour, #ff8800.'],
    ['bad.gpl', 'GIMP Palette\n1 2', 'Line 2 is “1 2”, not three numbers from 0 to 255.'],
    ['big.hex', Buffer.alloc(1024 * 1024 + 1, 'f'), 'The file is too large. The limit is 1 MB.'],
    ['colors.json', '{"colors":["<b>"]}', 'Colour 1 is "<b>"'],
    ['torn.jpg', 'JPEG', 'The browser cannot read it as a picture.'],
  ] as const) {
    await drop(page, name, content);
    await expect(page.getByText(`${name} could not be opened. ${message}`)).toBeVisible();
    await expect(page.getByRole('dialog')).toHaveCount(0);
  }
  expect(await valuesOf(page)).toEqual(before);
  const preset = { format: 'cartoon-smoke', version: 1, name: 'Sizes', preset: 'air', values: { 'puff.size': 2 } };
  await drop(page, 'sizes.json', JSON.stringify(preset));
  await expectValue(page, 'puff.size', 2);
});

test('the panel opens palettes, and axe finds nothing in the dialog', async ({ page }) => {
  await open(page, `?paused=1${LIGHT}`);
  const chosen = page.waitForEvent('filechooser');
  await row(page, 'style.ramp').getByRole('button', { name: 'From a palette or a picture' }).click();
  await (await chosen).setFiles({ name: 'sunset.gpl', mimeType: 'text/plain', buffer: Buffer.from(gpl) });
  await expect(dialog(page)).toBeVisible();
  const axe = new AxeBuilder({ page }).options({ resultTypes: ['violations'] }).setLegacyMode();
  const { violations } = await axe.analyze();
  expect(violations.flatMap(({ id, nodes }) => nodes.map(({ target }) => `${id}: ${String(target)}`))).toEqual([]);
  await dialog(page).getByRole('button', { name: 'Cancel' }).click();
  await expect(dialog(page)).toHaveCount(0);
  await page
    .getByLabel('Open a file')
    .last()
    .setInputFiles({ name: 'night.hex', mimeType: 'text/plain', buffer: Buffer.from(digits.join('\n')) });
  await expect(dialog(page).getByText('night.hex: 4 colours')).toBeVisible();
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 664 }, hasTouch: true, isMobile: true });

  test('the looks are below each other, and a tap chooses one', async ({ page }) => {
    await open(page, `?paused=1${LIGHT}`);
    await drop(page, 'a-palette-with-a-very-long-name-of-more-than-fifty-letters.gpl', gpl);
    const boxes = await Promise.all(
      ['Full range', 'Poster', 'Night'].map(async (name) => (await card(page, name).boundingBox())!),
    );
    expect(boxes[1].y).toBeGreaterThan(boxes[0].y + boxes[0].height);
    for (const { x, width } of boxes) {
      expect(x).toBeGreaterThanOrEqual(0);
      expect(x + width).toBeLessThanOrEqual(390);
    }
    expect(await dialog(page).evaluate(({ scrollWidth, clientWidth }) => scrollWidth - clientWidth)).toBe(0);
    await card(page, 'Night').tap();
    await expectValue(page, 'style.inkColor', COLORS[0]);
    await expect(dialog(page)).toHaveCount(0);
  });
});
