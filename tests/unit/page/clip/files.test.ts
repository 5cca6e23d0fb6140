/** Encoders of looped clips against another decoder. */
import { expect, test } from 'vitest';
import { Apng } from '../../../../src/page/clip/apng.ts';
import { changedArea, type ClipShape } from '../../../../src/page/clip/clipFile.ts';
import { Gif } from '../../../../src/page/clip/gif.ts';
import { Webp } from '../../../../src/page/clip/webp.ts';
import { decodeApng } from '../../../support/files/apng.ts';

const [WIDTH, HEIGHT] = [23, 17];
type Pixels = Uint8ClampedArray<ArrayBuffer>;
type Color = (x: number, y: number, frame: number) => readonly [number, number, number, number];

function framesOf(count: number, color: Color, width = WIDTH, height = HEIGHT): Pixels[] {
  return Array.from({ length: count }, (_frame, frame) => {
    const pixels = Array.from({ length: width * height }, (_pixel, at) =>
      color(at % width, Math.floor(at / width), frame),
    );
    return Uint8ClampedArray.from(pixels.flat());
  });
}

async function encoded(frames: readonly Pixels[], shape: ClipShape): Promise<Buffer> {
  const file = new Apng(shape);
  for (const pixels of frames) await file.add(pixels.slice());
  return Buffer.from(await file.finish().arrayBuffer());
}

const disc = (x: number, y: number, frame: number) => Math.hypot(x - 5 - frame, y - 8);

const PICTURES: Readonly<Record<string, Color>> = {
  'an opaque disc that moves over a backdrop': (x, y, frame) =>
    disc(x, y, frame) < 4 ? [250, 90, 30, 255] : [9, 60, y, 255],
  'a disc with a soft edge that moves over nothing': (x, y, frame) => {
    const alpha = Math.round(255 * Math.min(1, Math.max(0, 5 - disc(x, y, frame))));
    return alpha > 0 ? [200, 201 + frame, 255, alpha] : [0, 0, 0, 0];
  },
  'a disc that grows with a soft edge': (x, y, frame) => {
    const alpha = Math.round(255 * Math.min(1, Math.max(0, 2 + frame - disc(x, y, 0))));
    return alpha > 0 ? [8, 16, 24, alpha] : [0, 0, 0, 0];
  },
  'colours below an alpha of 0': (x, y, frame) => [x, y, 40 * frame, 0],
  'noise in all channels': (x, y, frame) => {
    const noise = (7919 * (x + 31 * y + 997 * frame)) >>> 3;
    return [noise & 255, (noise >> 2) & 255, (noise >> 4) & 255, (noise >> 1) & 255];
  },
  'a gradient': (x, y, frame) => [10 * x, 10 * y, 5 * (x + y) + frame, 255],
  'one picture that stays': (x, y) => [x, y, 0, x * y > 60 ? 255 : 80],
};

for (const [name, color] of Object.entries(PICTURES)) {
  test(`an APNG has every byte of ${name}`, async () => {
    const frames = framesOf(6, color);
    const decoded = decodeApng(await encoded(frames, { width: WIDTH, height: HEIGHT, rate: 24 }));
    expect(decoded).toMatchObject({ width: WIDTH, height: HEIGHT, plays: 0 });
    expect(decoded.frames.map((frame) => [...frame])).toEqual(frames.map((frame) => [...frame]));
  });
}

test('frames of an APNG after the first one are the rectangle that changes', async () => {
  const color: Color = (x, y, frame) => [x === 3 + frame && y > 4 && y < 9 ? 255 : 0, 0, 0, 255];
  const { areas } = decodeApng(await encoded(framesOf(3, color), { width: WIDTH, height: HEIGHT, rate: 24 }));
  expect(areas).toEqual([WIDTH * HEIGHT, 2 * 4, 2 * 4]);
});

test('opaque changes are smaller over what stays the same', async () => {
  const random = (x: number, y: number) => (Math.imul(x + 97 * y + 1, 0x9e3779b1) >>> 13) & 255;
  // Corners change, so that the rectangle is the whole frame.
  const changes = (x: number, y: number, frame: number) => frame === 1 && (x + y === 0 || x + y === 2 * 63);
  const clip = (alpha: number) =>
    framesOf(
      2,
      (x, y, frame) => [changes(x, y, frame) ? 255 : random(x, y), 0, 0, changes(x, y, frame) ? alpha : 255],
      64,
      64,
    );
  const shape = { width: 64, height: 64, rate: 24 };
  const [opaque, translucent] = [await encoded(clip(255), shape), await encoded(clip(254), shape)];
  expect(opaque.length).toBeLessThan(0.75 * translucent.length);
  expect(decodeApng(opaque).frames[1]).toEqual(Buffer.from(clip(255)[1]));
});

for (const [rate, delay] of [
  [24, 1 / 24],
  [12.5, 1 / 12.5],
  [60, 1 / 60],
  [24_000 / 1001, 1001 / 24_000],
  [59.123, 100 / 5912],
] as const) {
  test(`a frame of an APNG takes 1/${rate.toFixed(3)} s`, async () => {
    const { delays } = decodeApng(
      await encoded(framesOf(2, PICTURES['a gradient']), { width: WIDTH, height: HEIGHT, rate }),
    );
    expect(delays).toEqual([delay, delay]);
  });
}

test('one pixel is a clip', async () => {
  const frames = framesOf(2, (_x, _y, frame) => [1, 2, 3, 4 + frame], 1, 1);
  const decoded = decodeApng(await encoded(frames, { width: 1, height: 1, rate: 1 }));
  expect(decoded.frames.map((frame) => [...frame])).toEqual([
    [1, 2, 3, 4],
    [1, 2, 3, 5],
  ]);
});

const WRONG = {
  'a clip has 1 to 16383 pixels per side': [
    { width: 0, height: 0, rate: 24 },
    { width: 8, height: 0, rate: 24 },
    { width: 16_384, height: 8, rate: 24 },
    { width: 8, height: 1e9, rate: 24 },
    { width: 7.5, height: 8, rate: 24 },
    { width: NaN, height: 8, rate: 24 },
  ],
  'a clip has 1 to 60 frames per second': [
    { width: 8, height: 8, rate: 0 },
    { width: 8, height: 8, rate: 61 },
    { width: 8, height: 8, rate: NaN },
  ],
};

for (const [message, shapes] of Object.entries(WRONG)) {
  for (const shape of shapes) {
    test(`${message}, not ${JSON.stringify(shape)}`, () => {
      for (const File of [Apng, Webp, Gif]) expect(() => new File(shape)).toThrow(new RegExp(message, 'i'));
    });
  }
}

test('a rectangle has all changes, and its corner is on the grid', () => {
  const before = new Uint32Array(6 * 5);
  const after = before.slice();
  after[6 + 3] = 1;
  after[6 * 3 + 5] = 1;
  expect(changedArea(before, after, 6)).toEqual({ x: 3, y: 1, width: 3, height: 3 });
  expect(changedArea(before, after, 6, 2)).toEqual({ x: 2, y: 0, width: 4, height: 4 });
  expect(changedArea(before, before, 6)).toEqual({ x: 0, y: 0, width: 1, height: 1 });
});
