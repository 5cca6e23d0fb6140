/** Pictures by sim-wasm/reference, and their comparison with others. */
import { spawn } from 'node:child_process';
import { expect, test, type TestInfo } from '@playwright/test';
import { PNG } from 'pngjs';
import { buildNative } from './sim/nativeProgram.ts';

/** Rows from bottom to top. */
interface ReferencePicture {
  width: number;
  height: number;
  /** Four bytes per pixel. */
  colors: Uint8Array;
  /** Shadow volumes at each pixel, at most 255. */
  counts: Uint8Array;
  /** All pixels of a region show the same tone of the same object. */
  regions: Uint32Array;
  /** Largest allowed difference of a channel. */
  rounding: number;
}

/** The part of a description that this file reads. */
interface Described {
  width: number;
  height: number;
  style: { smokeRamps: readonly { isBlended?: boolean }[]; pattern?: object };
}

/** Largest difference of a channel between adjacent texels of the tests' smooth ramps. */
const BLENDED_TEXEL = 4;
/** At the edge of a mark, which moves by up to 1/20 pixel as places on puffs are rounded to 16 bits. */
const EDGE_OF_MARK = 13;

/** Differences from the reference. An edge pixel is one at which the reference changes to the next pixel. */
interface Difference {
  pixels: number;
  edges: number;
  /** Colours that differ by more than rounding, and counts that differ, within regions and at edges. */
  colors: number;
  counts: number;
  colorsAtEdges: number;
}

let program: Promise<string> | undefined;

/** Builds the program before the tests: a first build takes longer than the timeout of a test. */
export async function buildReference(): Promise<void> {
  test.setTimeout(1_200_000);
  program ??= buildNative('bin', 'reference');
  await program;
}

/** A picture and its description; bytes as base64, rows from bottom to top. */
export interface Drawn {
  /** JSON in the format of `Scene` in sim-wasm/reference/src/scene.rs. */
  description: string;
  pixels: string;
  /** Shadow volumes at each pixel. */
  counts: string;
}

/** Within regions rounding cannot cross a border. */
const MAX_WITHIN = 0.0001;
/** Share of the edge pixels. Causes: single precision, and board corners that snap to a grid of 1/16 pixel. */
const MAX_OF_EDGES = 0.01;
const MAX_COUNTS = 0.001;

/**
 * Expects a picture to match the reference: far fewer than 0.5 % of its pixels may have another colour. Prints the
 * numbers, and attaches both pictures on failure.
 * @param limits largest shares of wrong colours: of all pixels, within regions; and of edge pixels, which is larger for
 *   a few large puffs, because the corners of their boards dominate
 */
export async function expectReference(
  name: string,
  drawn: Drawn,
  testInfo: TestInfo,
  { maxWithin = MAX_WITHIN, maxOfEdges = MAX_OF_EDGES }: { maxWithin?: number; maxOfEdges?: number } = {},
): Promise<void> {
  const reference = await referencePicture(drawn.description);
  const [colors, counts] = [drawn.pixels, drawn.counts].map((text) => Uint8Array.from(Buffer.from(text, 'base64')));
  const difference = differenceFrom(reference, colors, counts);
  const share = (count: number) => count / difference.pixels;
  const percent = (count: number) => `${(100 * share(count)).toFixed(3)} %`;
  console.log(
    `${name}: ${percent(difference.colors)} of the pixels differ, ${percent(difference.colorsAtEdges)} more at edges,`,
    `${percent(difference.counts)} of the counts; ${percent(difference.edges)} are edges`,
  );
  const isSame = share(difference.colors) <= maxWithin && difference.colorsAtEdges <= maxOfEdges * difference.edges;
  if (!isSame) {
    await testInfo.attach(`${name}.png`, { body: sheetOf(reference, colors), contentType: 'image/png' });
  }
  expect.soft(isSame, `${name} is the reference's picture`).toBe(true);
  expect.soft(share(difference.counts), `${name}: shadow counts`).toBeLessThanOrEqual(MAX_COUNTS);
}

async function referencePicture(description: string): Promise<ReferencePicture> {
  const { width, height, style } = JSON.parse(description) as Described;
  program ??= buildNative('bin', 'reference');
  const bytes = await answer(await program, description);
  const pixels = width * height;
  return {
    width,
    height,
    colors: bytes.subarray(0, 4 * pixels),
    counts: bytes.subarray(4 * pixels, 5 * pixels),
    regions: new Uint32Array(bytes.slice(5 * pixels).buffer),
    rounding: style.pattern ? EDGE_OF_MARK : style.smokeRamps[0].isBlended ? BLENDED_TEXEL : 1,
  };
}

/** @param colors, counts of the other picture, rows from bottom to top */
function differenceFrom(reference: ReferencePicture, colors: Uint8Array, counts: Uint8Array): Difference {
  const difference: Difference = { pixels: reference.regions.length, edges: 0, colors: 0, counts: 0, colorsAtEdges: 0 };
  for (let pixel = 0; pixel < difference.pixels; pixel++) {
    const isOther = isOtherColor(reference, colors, pixel);
    if (isEdge(reference, pixel)) {
      difference.edges++;
      if (isOther) difference.colorsAtEdges++;
      continue;
    }
    if (isOther) difference.colors++;
    if (reference.counts[pixel] !== counts[pixel]) difference.counts++;
  }
  return difference;
}

/** The reference above the other picture, and the differences: red within regions, yellow at edges. */
function sheetOf(reference: ReferencePicture, colors: Uint8Array): Buffer {
  const { width, height } = reference;
  const sheet = new PNG({ width, height: 3 * height });
  for (let pixel = 0; pixel < width * height; pixel++) {
    const row = height - 1 - Math.floor(pixel / width);
    const isOther = isOtherColor(reference, colors, pixel);
    const grey = reference.colors[4 * pixel + 1] >> 1;
    const mark = isOther ? [255, isEdge(reference, pixel) ? 220 : 0, 0, 255] : [grey, grey, grey, 255];
    [reference.colors.subarray(4 * pixel, 4 * pixel + 4), colors.subarray(4 * pixel, 4 * pixel + 4), mark].forEach(
      (color, part) => sheet.data.set(color, 4 * ((part * height + row) * width + (pixel % width))),
    );
  }
  return PNG.sync.write(sheet);
}

function isOtherColor({ colors, rounding }: ReferencePicture, others: Uint8Array, pixel: number): boolean {
  return [0, 1, 2, 3].some((channel) => Math.abs(colors[4 * pixel + channel] - others[4 * pixel + channel]) > rounding);
}

function isEdge({ width, height, regions }: ReferencePicture, pixel: number): boolean {
  const [x, y] = [pixel % width, Math.floor(pixel / width)];
  for (let j = Math.max(0, y - 1); j <= Math.min(height - 1, y + 1); j++) {
    for (let i = Math.max(0, x - 1); i <= Math.min(width - 1, x + 1); i++) {
      if (regions[j * width + i] !== regions[pixel]) return true;
    }
  }
  return false;
}

function answer(executable: string, question: string): Promise<Uint8Array> {
  return new Promise((resolve, reject) => {
    const child = spawn(executable, { stdio: ['pipe', 'pipe', 'inherit'] });
    const parts: Buffer[] = [];
    child.stdout.on('data', (part: Buffer) => parts.push(part));
    child.on('error', reject);
    child.on('close', (status) =>
      status === 0
        ? resolve(Uint8Array.from(Buffer.concat(parts)))
        : reject(new Error(`the reference ended with ${status}`)),
    );
    child.stdin.end(question);
  });
}
