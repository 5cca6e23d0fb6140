/** PNGs of puff sheets against pngjs: every byte, also where alpha is 0. */
import { deflateSync } from 'node:zlib';
import { PNG } from 'pngjs';
import { expect, test } from 'vitest';
import { ShapeError } from '../../../src/base/errors.ts';
import { decodePng, encodePng } from '../../../src/demo/gallery/straightPng.ts';

const [WIDTH, HEIGHT] = [37, 29];
/** Smooth and noisy channels; alpha is 0 in the first rows. */
const DATA = Uint8Array.from({ length: 4 * WIDTH * HEIGHT }, (_, at) => {
  const pixel = at >> 2;
  return at % 4 === 3 ? Math.max(0, Math.floor(pixel / WIDTH) - 5) * 9 : at % 4 === 0 ? pixel : (pixel * 7919) >> 3;
});

const fileOf = (bytes: Uint8Array, name = 'sheet.png') => new File([Uint8Array.from(bytes)], name);

test('what is encoded is decoded to the same bytes, here and by pngjs', async () => {
  const blob = await encodePng({ width: WIDTH, height: HEIGHT, data: DATA });
  const bytes = new Uint8Array(await blob.arrayBuffer());
  expect(await decodePng(fileOf(bytes))).toEqual({ width: WIDTH, height: HEIGHT, data: DATA });
  const other = PNG.sync.read(Buffer.from(bytes), { checkCRC: true });
  expect([other.width, other.height]).toEqual([WIDTH, HEIGHT]);
  expect(Uint8Array.from(other.data)).toEqual(DATA);
});

for (const filterType of [0, 1, 2, 3, 4]) {
  test(`filter ${filterType}`, async () => {
    const png = Object.assign(new PNG({ width: WIDTH, height: HEIGHT }), { data: Buffer.from(DATA) });
    expect((await decodePng(fileOf(PNG.sync.write(png, { filterType })))).data).toEqual(DATA);
  });
}

/** Types of colour with their samples and bits. */
const KINDS = [
  [0, 1, 1], [0, 1, 2], [0, 1, 4], [0, 1, 8], [0, 1, 16], [2, 3, 8], [2, 3, 16], [3, 1, 2], [3, 1, 8], [4, 2, 8], [4, 2, 16], [6, 4, 16],
] as const; // prettier-ignore

for (const [type, samples, depth] of KINDS) {
  test(`colours of type ${type} with ${depth} bits are those of pngjs`, async () => {
    const stride = Math.ceil((WIDTH * samples * depth) / 8);
    const palette = Array.from({ length: 2 ** Math.min(8, depth) }, (_, at) => [at, 255 - at, (at * 91) % 256]);
    const lines = Uint8Array.from({ length: (stride + 1) * HEIGHT }, (_, at) =>
      at % (stride + 1) ? (at * 151) >> 2 : 0,
    );
    const file = pngOf([
      ['IHDR', [0, 0, 0, WIDTH, 0, 0, 0, HEIGHT, depth, type, 0, 0, 0]],
      ...(type === 3
        ? ([
            ['PLTE', palette.flat()],
            ['tRNS', [0, 100]],
          ] as const)
        : []),
      ['IDAT', [...deflateSync(lines)]],
    ]);
    const expected = Uint8Array.from(PNG.sync.read(Buffer.from(file), { checkCRC: false }).data);
    const data = Uint8Array.from((await decodePng(fileOf(file))).data);
    // From 16 bits, pngjs rounds, and this decoder takes the upper byte.
    const off = data.reduce((most, byte, at) => Math.max(most, Math.abs(byte - expected[at])), 0);
    expect(off).toBeLessThanOrEqual(depth === 16 ? 1 : 0);
    expect(new Set(data).size).toBeGreaterThan(depth === 1 ? 1 : 3);
  });
}

/** Without checks: decoders of browsers test them, and nothing here depends on them. */
function pngOf(chunks: readonly (readonly [kind: string, content: readonly number[]])[]): Uint8Array {
  const parts = [...chunks, ['IEND', []] as const].map(([kind, content]) => {
    const whole = Buffer.alloc(12 + content.length);
    whole.writeUInt32BE(content.length);
    whole.write(kind, 4, 'latin1');
    whole.set(content, 8);
    return whole;
  });
  return Buffer.concat([Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]), ...parts]);
}

const header = (width: number, height: number, type = 6, interlace = 0) =>
  ['IHDR', [width >> 24, (width >> 16) & 255, (width >> 8) & 255, width & 255, height >> 24, (height >> 16) & 255, (height >> 8) & 255, height & 255, 8, type, 0, 0, interlace]] as const; // prettier-ignore
const rows = (count: number) => ['IDAT', [...deflateSync(new Uint8Array(count))]] as const;
const whole = await encodePng({ width: WIDTH, height: HEIGHT, data: DATA }).then(
  async (blob) => new Uint8Array(await blob.arrayBuffer()),
);

const HOSTILE: readonly (readonly [string, Uint8Array, RegExp])[] = [
  ['an empty file', new Uint8Array(), /not a PNG. Save/],
  ['a text', new TextEncoder().encode('not an image'), /not a PNG/],
  ['a JPEG', Uint8Array.from([0xff, 0xd8, 0xff, 0xe0, 0, 0x10]), /not a PNG/],
  ['a file that is cut in its header', whole.subarray(0, 20), /damaged/],
  ['a file that is cut in its picture', whole.subarray(0, whole.length >> 1), /damaged/],
  ['fewer rows than it says', pngOf([header(9, 9), rows(37 * 8)]), /damaged/],
  ['an unknown filter', pngOf([header(9, 9), ['IDAT', [...deflateSync(new Uint8Array(37 * 9).fill(7))]]]), /damaged/],
  ['a picture that is not compressed', pngOf([header(9, 9), ['IDAT', [1, 2, 3, 4]]]), /damaged/],
  ['more pixels than the limit', pngOf([header(8193, 8), rows(9)]), /8193 x 8 pixels. The limit is 8192 x 8192/],
  ['a size that no memory holds', pngOf([header(0x7fffffff, 0x7fffffff), rows(9)]), /The limit is/],
  ['interlacing', pngOf([header(9, 9, 6, 1), rows(37 * 9)]), /without interlacing/],
  ['a transparent colour', pngOf([header(9, 9, 2), ['tRNS', [0, 0, 0, 0, 0, 0]], rows(28 * 9)]), /with alpha/],
];

for (const [name, bytes, message] of HOSTILE) {
  test(`${name} is a ShapeError that names the file`, async () => {
    const error = await decodePng(fileOf(bytes, 'puffs.png')).catch((thrown: unknown) => thrown);
    expect(error).toBeInstanceOf(ShapeError);
    expect(String(error)).toMatch(message);
    expect(String(error)).toContain('puffs.png');
  });
}

test('a picture that expands beyond its size is read up to there', async () => {
  const bomb = pngOf([header(9, 9), rows(50_000_000)]);
  expect((await decodePng(fileOf(bomb))).data).toEqual(new Uint8Array(4 * 81));
});
