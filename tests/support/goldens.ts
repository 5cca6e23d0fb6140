/**
 * Compares pictures with the goldens in tests/visual/goldens.
 *
 * A pixel is an outlier when any of its four channels differs by more than the case's tolerance. There are no
 * exceptions: edge pixels count as well, because ink lines consist of them.
 */
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, type JSHandle, type TestInfo } from '@playwright/test';
import { PNG } from 'pngjs';

const FOLDER = fileURLToPath(new URL('../visual/goldens', import.meta.url));

export interface GoldenCase {
  /** File name without extension. */
  readonly name: string;
  /** Largest tolerated difference of a channel, 0 to 255. */
  readonly tolerance: number;
  /** Largest number of outliers. */
  readonly outliers: number;
}

export interface Comparison {
  /** Number of pixels that differ by more than the tolerance. */
  readonly outliers: number;
  /** Largest difference of any channel, 0 to 255. */
  readonly largest: number;
  /** The golden in grey with the outliers in red. */
  readonly difference: PNG;
}

/**
 * Expects a picture to match its golden. On a mismatch the picture, the golden and their difference are attached to the
 * test result. `npm run test:update` rewrites the goldens; otherwise a missing golden fails.
 *
 * @param picture a PNG file's bytes
 */
export async function expectGolden(picture: Buffer, golden: GoldenCase, testInfo: TestInfo): Promise<void> {
  const path = join(FOLDER, `${golden.name}.png`);
  if (process.env.UPDATE_GOLDENS) {
    mkdirSync(dirname(path), { recursive: true });
    writeFileSync(path, picture);
    return;
  }
  expect(existsSync(path), `golden ${golden.name}: look at the picture, then npm run test:update`).toBe(true);
  await expectSame(picture, readFileSync(path), golden, testInfo);
}

/** The same for two PNG files. Uses a soft assertion: the test continues after a mismatch and fails at its end. */
export async function expectSame(
  picture: Buffer,
  expected: Buffer,
  golden: GoldenCase,
  testInfo: TestInfo,
): Promise<void> {
  const comparison = compare(PNG.sync.read(picture), PNG.sync.read(expected), golden.tolerance);
  if (comparison.outliers > golden.outliers) {
    await attach(testInfo, golden.name, {
      picture,
      golden: expected,
      difference: PNG.sync.write(comparison.difference),
    });
  }
  const what = `pixels of ${golden.name} that differ by more than ${golden.tolerance}, at most by ${comparison.largest}`;
  expect.soft(comparison.outliers, what).toBeLessThanOrEqual(golden.outliers);
}

/** Compares two pictures channel by channel. If their sizes differ, every pixel of the golden is an outlier. */
export function compare(picture: PNG, golden: PNG, tolerance: number): Comparison {
  const pixels = golden.width * golden.height;
  const difference = new PNG({ width: golden.width, height: golden.height });
  if (picture.width !== golden.width || picture.height !== golden.height) {
    return { outliers: pixels, largest: 255, difference };
  }
  let outliers = 0;
  let largest = 0;
  for (let i = 0; i < pixels; i++) {
    const distance = channelDistance(picture.data, golden.data, 4 * i);
    largest = Math.max(largest, distance);
    if (distance > tolerance) outliers++;
    difference.data.set(distance > tolerance ? [255, 0, 0, 255] : greyOf(golden.data, 4 * i), 4 * i);
  }
  return { outliers, largest, difference };
}

/** The bytes of a Blob in a page, such as the result of `stage.picture()`. */
export async function bytesOf(blob: JSHandle<Blob>): Promise<Buffer> {
  const text = await blob.evaluate(async (it) => {
    const bytes = new Uint8Array(await it.arrayBuffer());
    let binary = '';
    for (const byte of bytes) binary += String.fromCharCode(byte);
    return btoa(binary);
  });
  return Buffer.from(text, 'base64');
}

function channelDistance(a: Uint8Array, b: Uint8Array, at: number): number {
  let largest = 0;
  for (let channel = 0; channel < 4; channel++) {
    largest = Math.max(largest, Math.abs(a[at + channel] - b[at + channel]));
  }
  return largest;
}

function greyOf(data: Uint8Array, at: number): [number, number, number, number] {
  const grey = Math.round((data[at] + data[at + 1] + data[at + 2]) / 3);
  return [grey, grey, grey, 255];
}

async function attach(testInfo: TestInfo, name: string, pictures: Record<string, Buffer>): Promise<void> {
  for (const [kind, body] of Object.entries(pictures)) {
    await testInfo.attach(`${name}-${kind}.png`, { body, contentType: 'image/png' });
  }
}
