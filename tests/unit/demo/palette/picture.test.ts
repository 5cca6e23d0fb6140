/** The colours of pictures. */
import { describe, expect, it } from 'vitest';
import { finished } from '../../../../src/base/work.ts';
import { distance, labOf } from '../../../../src/demo/palette/color.ts';
import { findingColors } from '../../../../src/demo/palette/picture.ts';

const SIDE = 128;

type Pixel = readonly [red: number, green: number, blue: number, alpha?: number];

function picture(pixelAt: (x: number, y: number) => Pixel): Uint8ClampedArray {
  const data = new Uint8ClampedArray(4 * SIDE * SIDE);
  for (let at = 0; at < SIDE * SIDE; at++) {
    const [red, green, blue, alpha = 255] = pixelAt(at % SIDE, Math.floor(at / SIDE));
    data.set([red, green, blue, alpha], 4 * at);
  }
  return data;
}

const colorsOf = (data: Uint8ClampedArray) => finished(findingColors(data));

/** Numbers from 0 to 1, always the same. */
function randoms(): () => number {
  let state = 7;
  return () => (state = (state * 48271) % 2147483647) / 2147483647;
}

describe('the colours of a picture', () => {
  it('are exact where areas are flat, with their shares', () => {
    const found = colorsOf(
      picture((x) => (x < 64 ? [255, 0, 0] : x < 96 ? [0, 0, 255] : x < 120 ? [255, 255, 255] : [0, 0, 0])),
    );
    expect(found).toEqual([
      { color: '#ff0000', share: 0.5 },
      { color: '#0000ff', share: 0.25 },
      { color: '#ffffff', share: 0.1875 },
      { color: '#000000', share: 0.0625 },
    ]);
  });

  it('include a small vivid area in a dull gradient', () => {
    const found = colorsOf(
      picture((x, y) =>
        x >= 60 && x < 68 && y >= 60 && y < 68 ? [230, 30, 40] : [90 + y / 2, 100 + y / 2, 110 + y / 2],
      ),
    );
    const red = found.find(({ color }) => distance(labOf(color), labOf('#e61e28')) < 0.01);
    expect(red?.share).toBeCloseTo(64 / SIDE ** 2, 4);
    // The gradient is a few greys.
    expect(found.length).toBeGreaterThan(3);
    expect(found.length).toBeLessThan(9);
  });

  it('include it beside more large areas than there are colours', () => {
    const found = colorsOf(
      picture((x, y) => (x < 8 && y < 8 ? [240, 20, 40] : [60 + 45 * (x >> 5), 60 + 45 * (y >> 5), 120])),
    );
    expect(found).toHaveLength(12);
    expect(found.map(({ color }) => color)).toContain('#f01428');
  });

  it('include no mixtures of smooth edges', () => {
    const mixed = (share: number): Pixel => [255 * share, 200 * share + 40 * (1 - share), 90 * (1 - share)];
    const found = colorsOf(picture((x) => mixed(Math.min(1, Math.max(0, x - 62)))));
    const smooth = colorsOf(picture((x) => mixed(Math.min(1, Math.max(0, (x - 62) / 3)))));
    expect(smooth.map(({ color }) => color).sort()).toEqual(found.map(({ color }) => color).sort());
    expect(found).toHaveLength(2);
  });

  it('are at most 12 and the same every time, also of noise', () => {
    const random = randoms();
    const noise = picture(() => [255 * random(), 255 * random(), 255 * random()]);
    const found = colorsOf(noise);
    expect(found.length).toBeLessThanOrEqual(12);
    expect(found.length).toBeGreaterThan(6);
    expect(found.reduce((sum, { share }) => sum + share, 0)).toBeLessThanOrEqual(1.000001);
    expect(colorsOf(noise)).toEqual(found);
    for (const [at, { color }] of found.entries()) {
      for (const other of found.slice(at + 1)) expect(distance(labOf(color), labOf(other.color))).toBeGreaterThan(0.03);
    }
  });

  it('leave out transparent pixels', () => {
    expect(colorsOf(picture((x) => (x < 4 ? [0, 200, 0] : [255, 0, 0, 100])))).toEqual([
      { color: '#00c800', share: 1 },
    ]);
    expect(colorsOf(picture(() => [0, 0, 0, 0]))).toEqual([]);
  });

  it('are found in short pieces', () => {
    const random = randoms();
    const work = findingColors(picture(() => [255 * random(), 255 * random(), 255 * random()]));
    let pieces = 0;
    while (!work.next().done) pieces++;
    expect(pieces).toBeGreaterThan(50);
  });
});
