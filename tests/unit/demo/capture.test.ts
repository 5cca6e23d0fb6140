import { expect, test } from 'vitest';
import { indexFrame } from '../../../src/page/clip/gif.ts';
import { labelColors, type Labels } from '../../../src/demo/capture/labels.ts';
import type { Point } from '../../../src/page/outline/simplify.ts';
import { traceRegion } from '../../../src/demo/capture/svg.ts';

const [RED, GREEN, BLUE] = [0xff2030c0, 0xff30c020, 0xffc03020];

/** Three sectors around a point, and a disc in the first. */
function sectors(size = 64): ImageData {
  const pixels = Uint32Array.from({ length: size * size }, (_, at) => {
    const [x, y] = [(at % size) - size / 2.3, Math.floor(at / size) - size / 2.1];
    if (Math.hypot(x - 14, y - 8) < 7) return BLUE;
    const angle = Math.atan2(y, x);
    return angle > 2 ? GREEN : angle > -1 ? RED : BLUE;
  });
  return { data: new Uint8ClampedArray(pixels.buffer), width: size, height: size } as unknown as ImageData;
}

/** Twice the enclosed area, without holes. */
function doubledArea(outlines: Point[][]): number {
  const cross = (outline: Point[]) =>
    outline.reduce((sum, [x, y], at) => {
      const [nextX, nextY] = outline[(at + 1) % outline.length];
      return sum + x * nextY - y * nextX;
    }, 0);
  return outlines.reduce((sum, outline) => sum + cross(outline), 0);
}

function outlinesOf(labels: Labels): Point[][][] {
  return labels.colors.slice(1).map((_, number) => traceRegion(labels, number + 1, 0.6));
}

test('outlines have the area of their pixels and cover the picture without gaps', () => {
  const labels = labelColors(sectors());
  const outlines = outlinesOf(labels);
  const areas = outlines.map((each) => doubledArea(each) / 2);
  areas.forEach((area, region) => {
    const pixels = labels.of.filter((number) => number === region + 1).length;
    expect(Math.abs(area - pixels)).toBeLessThan(0.02 * pixels);
  });
  expect(areas.reduce((sum, area) => sum + area)).toBeCloseTo(64 * 64, 6);
});

test('a straight outline has few points, and holes are preserved', () => {
  const outlines = outlinesOf(labelColors(sectors()));
  const points = outlines.flat(2).length;
  expect(points).toBeLessThan(90);
  const holes = outlines.flat().filter((outline) => doubledArea([outline]) < 0);
  expect(holes).toHaveLength(1);
});

test('a blended pixel gets the colour of its nearest neighbour', () => {
  const image = sectors();
  const pixels = new Uint32Array(image.data.buffer);
  const before = labelColors(image);
  const row = 20 * 64;
  const edge = pixels.subarray(row, row + 64).findIndex((pixel, at, all) => at > 0 && pixel !== all[at - 1]);
  const isBlue = pixels[row + edge] === BLUE;
  pixels[row + edge] = isBlue ? 0xffb03030 : 0xff2038b8;
  expect(labelColors(image).of).toEqual(before.of);
});

test('a GIF keeps the most frequent colours exactly, and transparent pixels transparent', () => {
  const image = sectors();
  const pixels = new Uint32Array(image.data.buffer);
  for (let at = 0; at < 300; ++at) pixels[at] = 0xff000000 + at * 700;
  pixels[400] = 0x10ffffff;
  const { palette, indices, transparent } = indexFrame(image.data);
  expect(palette.length).toBeLessThanOrEqual(256);
  expect(indices[400]).toBe(transparent);
  for (const at of [64 * 40, 64 * 40 + 40, 64 * 60 + 10]) {
    const [red, green, blue] = palette[indices[at]];
    expect(0xff000000 + red + 256 * green + 65536 * blue).toBe(pixels[at]);
  }
});
