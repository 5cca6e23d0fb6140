/** Captures, configured in the dialog and received as downloads. */
import { fileURLToPath } from 'node:url';
import type { Download, Page } from '@playwright/test';
import { expect, test } from '../../support/fixtures.ts';
import { ask, closeSheet, LAMP, open } from './page.ts';

test.use({ viewport: { width: 400, height: 300 }, deviceScaleFactor: 1 });

type Media = typeof import('mediabunny');
const MEDIABUNNY = fileURLToPath(
  new URL('../../../node_modules/mediabunny/dist/bundles/mediabunny.min.cjs', import.meta.url),
);

const sheet = (page: Page) => page.getByRole('dialog', { name: 'Capture the smoke' });
const press = (page: Page) => sheet(page).getByRole('button', { name: 'Capture', exact: true }).click();

async function openSheet(page: Page): Promise<string> {
  await page.keyboard.press('c');
  await expect(sheet(page)).toBeVisible();
  return ask(page, (stage) => stage.hash());
}

async function bytesOf(file: Download): Promise<number[]> {
  const chunks: Buffer[] = [];
  for await (const chunk of await file.createReadStream()) chunks.push(chunk as Buffer);
  return Array.from(Buffer.concat(chunks));
}

/**
 * Bytes of colour that change between consecutive frames of a film. Decodes frame by frame, because a video element may
 * show a frame some time after its `seeked` event.
 */
async function movesOf(page: Page, film: number[]): Promise<number[]> {
  await page.addScriptTag({ path: MEDIABUNNY });
  return page.evaluate(async (bytes) => {
    const { ALL_FORMATS, BlobSource, Input, VideoSampleSink } = (window as unknown as { Mediabunny: Media }).Mediabunny;
    const input = new Input({ source: new BlobSource(new Blob([Uint8Array.from(bytes)])), formats: ALL_FORMATS });
    const frames: Uint8ClampedArray[] = [];
    for await (const sample of new VideoSampleSink((await input.getPrimaryVideoTrack())!).samples()) {
      const { displayWidth, displayHeight } = sample;
      const context = new OffscreenCanvas(displayWidth, displayHeight).getContext('2d')!;
      sample.draw(context, 0, 0);
      sample.close();
      frames.push(context.getImageData(0, 0, displayWidth, displayHeight).data);
    }
    const later = frames.slice(1);
    return later.map((data, at) => data.filter((value, byte) => Math.abs(value - frames[at][byte]) > 24).length);
  }, film);
}

async function captured(page: Page): Promise<{ name: string; bytes: number[] }> {
  const [file] = await Promise.all([page.waitForEvent('download'), press(page)]);
  await expect(sheet(page).getByRole('status')).toContainText(`Saved ${file.suggestedFilename()}`);
  return { name: file.suggestedFilename(), bytes: await bytesOf(file) };
}

test('captures are started from the sheet and do not change the smoke', async ({ page }) => {
  await open(page, `?paused=1${LAMP}`);
  await ask(page, (stage) => stage.step(60));
  await test.step('a video from the sheet has all frames, and neighbours differ', async () => {
    const hash = await openSheet(page);
    await sheet(page).getByLabel('Format').selectOption('webm');
    await sheet(page).getByLabel('Seconds').fill('0.25');
    await sheet(page).getByLabel('Frame rate').selectOption('12');
    await expect(sheet(page).getByText('3 frames of 400 × 300 pixels.')).toBeVisible();
    const { name, bytes } = await captured(page);
    expect(name).toBe('lamp-1.00s.webm');
    const moves = await movesOf(page, bytes);
    expect(moves).toHaveLength(2);
    for (const moved of moves) expect(moved).toBeGreaterThan(50);
    expect(await ask(page, (stage) => stage.hash())).toBe(hash);
    await closeSheet(page);
  });
  await test.step('a long clip is stopped by its button, and by closing the sheet', async () => {
    const hash = await openSheet(page);
    await sheet(page).getByLabel('Format').selectOption('gif');
    await sheet(page).getByLabel('Seconds').fill('60');
    await press(page);
    await expect(sheet(page).getByRole('progressbar', { name: 'Drawing frame by frame' })).toBeVisible();
    await sheet(page).getByRole('button', { name: 'Stop here' }).click();
    await expect(sheet(page).getByText('Stopped. The smoke is unchanged.')).toBeVisible();
    await press(page);
    await expect(sheet(page).getByRole('progressbar', { name: 'Drawing frame by frame' })).toBeVisible();
    await closeSheet(page);
    await page.keyboard.press('c');
    await expect(sheet(page).getByLabel('Format')).toBeEnabled();
    expect(await ask(page, (stage) => stage.hash())).toBe(hash);
    await closeSheet(page);
  });
  await test.step('a picture from the sheet has the chosen size and a transparent background', async () => {
    const hash = await openSheet(page);
    await sheet(page).getByLabel('Format').selectOption('png');
    await sheet(page).getByLabel('Scale').selectOption('2');
    await sheet(page).getByLabel('With background').uncheck();
    await expect(sheet(page).getByText('800 × 600 pixels.')).toBeVisible();
    const { name, bytes } = await captured(page);
    expect(name).toBe('lamp-1.00s.png');
    const picture = await page.evaluate(async (given) => {
      const image = await createImageBitmap(new Blob([Uint8Array.from(given)]));
      const context = new OffscreenCanvas(image.width, image.height).getContext('2d')!;
      context.drawImage(image, 0, 0);
      const { data } = context.getImageData(0, 0, image.width, image.height);
      const opaque = data.filter((value, at) => at % 4 === 3 && value === 255).length;
      return { size: [image.width, image.height], corner: data[3], opaque: opaque / (data.length / 4) };
    }, bytes);
    expect(picture).toMatchObject({ size: [800, 600], corner: 0 });
    expect(picture.opaque).toBeGreaterThan(0.05);
    await closeSheet(page);
    expect(await ask(page, (stage) => [stage.hash(), stage.playing])).toEqual([hash, false]);
  });
});

test('sizes of a clip in all formats stand beside each other before one is saved, by keys @long', async ({ page }) => {
  await open(page, `?paused=1${LAMP}`);
  await ask(page, (stage) => stage.step(60));
  const hash = await openSheet(page);
  const table = sheet(page).getByRole('table', { name: 'Sizes of this clip' });
  const compare = sheet(page).getByRole('button', { name: 'Compare sizes' });
  await expect(compare, 'for a picture').toBeHidden();
  await sheet(page).getByLabel('Format').selectOption('webp');
  await sheet(page).getByLabel('Frame rate').selectOption('12');
  await test.step('a long one is stopped', async () => {
    await sheet(page).getByLabel('Seconds').fill('60');
    await compare.press('Enter');
    await expect(sheet(page).getByRole('progressbar', { name: 'Drawing the clip in each format' })).toBeVisible();
    await sheet(page).getByRole('button', { name: 'Stop here' }).press('Enter');
    await expect(sheet(page).getByText('Stopped. The smoke is unchanged.')).toBeVisible();
    await expect(table).toBeHidden();
  });
  await sheet(page).getByLabel('Seconds').fill('0.25');
  await compare.press('Enter');
  await expect(sheet(page).getByText('The clip is ready in 5 formats.')).toBeVisible();
  const names = ['APNG', 'WebP', 'GIF', 'WebM', 'MP4'];
  await expect(table.getByRole('rowheader')).toHaveText(names);
  const row = table.getByRole('row').filter({ hasText: 'APNG' });
  const [, shown] = /([\d.]+) MB/.exec(await row.innerText())!;
  const button = sheet(page).getByRole('button', { name: 'Save APNG' });
  const [file] = await Promise.all([page.waitForEvent('download'), button.press('Enter')]);
  expect(file.suggestedFilename()).toBe('lamp-1.00s.apng');
  const { length } = await bytesOf(file);
  expect(Math.abs(length / 1e6 - Number(shown))).toBeLessThan(0.0051);
  await expect(sheet(page).getByRole('status')).toContainText('Saved lamp-1.00s.apng');
  await expect(table, 'others can be saved, too').toBeVisible();
  await sheet(page).getByLabel('Frame rate').selectOption('24');
  await expect(table, 'for other settings').toBeHidden();
  expect(await ask(page, (stage) => stage.hash())).toBe(hash);
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test('a finger reaches the whole sheet @long', async ({ page }) => {
    await open(page, `?paused=1${LAMP}`);
    await page.getByRole('button', { name: 'Capture' }).tap();
    await sheet(page).getByLabel('Format').selectOption('zip');
    for (const button of await sheet(page).getByRole('button').all()) {
      const box = (await button.boundingBox())!;
      expect(box.x).toBeGreaterThanOrEqual(0);
      expect(box.x + box.width).toBeLessThanOrEqual(390);
      expect(box.y + box.height).toBeLessThanOrEqual(844);
    }
    await sheet(page).getByRole('button', { name: 'Close' }).tap();
    await expect(sheet(page)).toBeHidden();
  });
});
