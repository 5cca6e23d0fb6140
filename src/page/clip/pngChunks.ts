/** The parts of PNG files. */
import type { PixelImage } from '../../renderer/puffs/shapes.ts';

export const SIGNATURE = Uint8Array.of(137, 80, 78, 71, 13, 10, 26, 10);

/** Filters of rows that are tried: bytes as they are, and differences to the left, above and to both. */
export const FILTERS = { none: 0, left: 1, above: 2, both: 4 } as const;
export type Filter = (typeof FILTERS)[keyof typeof FILTERS];

/** The header of pictures of 8 bits with alpha. */
export function header(width: number, height: number): Uint8Array<ArrayBuffer> {
  const content = new Uint8Array(13);
  const sizes = new DataView(content.buffer);
  sizes.setUint32(0, width);
  sizes.setUint32(4, height);
  content.set([8, 6, 0, 0, 0], 8);
  return chunk('IHDR', content);
}

/** A chunk with its length and check. */
export function chunk(kind: string, content: Uint8Array): Uint8Array<ArrayBuffer> {
  const whole = new Uint8Array(12 + content.length);
  const view = new DataView(whole.buffer);
  view.setUint32(0, content.length);
  whole.set(new TextEncoder().encode(kind), 4);
  whole.set(content, 8);
  view.setUint32(8 + content.length, crc(whole.subarray(4, 8 + content.length)));
  return whole;
}

/**
 * Applies a filter to a picture in pieces.
 * @returns the rows, each after the byte of its filter
 */
export function* filtered(
  { width, height, data }: PixelImage,
  filter: Filter,
): Generator<undefined, Uint8Array<ArrayBuffer>> {
  const stride = 4 * width;
  const rows = new Uint8Array((stride + 1) * height);
  for (let row = 0; row < height; row++) {
    const first = row * (stride + 1);
    rows[first] = filter;
    for (let at = 0, from = row * stride; at < stride; at++, from++) {
      const left = at >= 4 ? data[from - 4] : 0;
      const above = row > 0 ? data[from - stride] : 0;
      const corner = at >= 4 && row > 0 ? data[from - stride - 4] : 0;
      rows[first + 1 + at] = data[from] - predicted(filter, left, above, corner);
    }
    if (row % 32 === 31) yield;
  }
  return rows;
}

/** What a filter subtracts of a byte. */
export function predicted(filter: number, left: number, above: number, corner: number): number {
  if (filter === 0) return 0;
  if (filter === 1) return left;
  if (filter === 2) return above;
  if (filter === 3) return (left + above) >> 1;
  const estimate = left + above - corner;
  const fromLeft = Math.abs(estimate - left);
  const fromAbove = Math.abs(estimate - above);
  const fromCorner = Math.abs(estimate - corner);
  if (fromLeft <= fromAbove && fromLeft <= fromCorner) return left;
  return fromAbove <= fromCorner ? above : corner;
}

/** Compresses filtered rows. */
export async function deflated(rows: Uint8Array<ArrayBuffer>): Promise<Uint8Array<ArrayBuffer>> {
  const stream = new Blob([rows]).stream().pipeThrough(new CompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** The cyclic redundancy check of PNG (ISO 3309). */
function crc(bytes: Uint8Array): number {
  let rest = -1;
  for (const byte of bytes) rest = CRC_TABLE[(rest ^ byte) & 0xff] ^ (rest >>> 8);
  return ~rest >>> 0;
}

const CRC_TABLE = Int32Array.from({ length: 256 }, (_, byte) => {
  let rest = byte;
  for (let bit = 0; bit < 8; bit++) rest = rest & 1 ? 0xedb88320 ^ (rest >>> 1) : rest >>> 1;
  return rest;
});
