import { isSame, NOISE } from './pixels.ts';

/** An image in a few flat colours, as indices. */
export interface Labels {
  readonly width: number;
  readonly height: number;
  /** Colour index of each pixel in row order; 0 is transparent. */
  readonly of: Uint8Array;
  /** Colours as 0xAABBGGRR, by index; the first one is transparent. */
  readonly colors: readonly number[];
}

/** Colours with fewer pixels are treated as antialiasing. */
const MIN_SHARE = 1 / 20_000;
const MIN_PIXELS = 4;
const MAX_COLORS = 64;
const HALF = 128;

/**
 * Assigns each pixel one of the most common colours. Antialiased pixels take the nearest of the flat colours next to
 * them, so that no outline of a third colour appears between two regions.
 */
export function labelColors({ data, width, height }: ImageData): Labels {
  const pixels = new Uint32Array(data.buffer);
  const colors = commonestColors(pixels);
  const numbers = new Map<number, number>();
  const numberOf = (color: number) => {
    const number = numbers.get(color) ?? colors.findIndex((other) => isSame(color, other));
    numbers.set(color, number);
    return number < 0 || color === EDGE ? UNKNOWN : number;
  };
  const found = Uint8Array.from(pixels, (pixel) => numberOf(settled(pixel)));
  const labels = { width, height, of: found.slice(), colors };
  for (let at = 0; at < found.length; ++at) {
    if (found[at] === UNKNOWN) labels.of[at] = nearestOf(beside(found, at, width), colors, pixels[at]);
  }
  return labels;
}

const UNKNOWN = 255;
/** In place of partially transparent pixels. */
const EDGE = 1;
const HIGH_BITS = ~0x010101;

/** Returns opaque pixels with full alpha, transparent ones as 0 and partially transparent ones as an edge. */
function settled(pixel: number): number {
  const alpha = pixel >>> 24;
  return alpha <= NOISE ? 0 : alpha >= 255 - NOISE ? (pixel | 0xff000000) >>> 0 : EDGE;
}

function commonestColors(pixels: Uint32Array): number[] {
  const counts = new Map<number, number>();
  // Falsified pixels of one colour differ in their lowest bits.
  const sums = new Map<number, number>();
  for (const pixel of pixels) {
    const color = settled(pixel);
    if (color === EDGE || color === 0) continue;
    counts.set(color, (counts.get(color) ?? 0) + 1);
    sums.set(color & HIGH_BITS, (sums.get(color & HIGH_BITS) ?? 0) + 1);
  }
  const least = Math.max(MIN_PIXELS, MIN_SHARE * pixels.length);
  const colors = [0];
  for (const [color] of [...counts].sort(([, a], [, b]) => b - a)) {
    if (colors.length > MAX_COLORS) break;
    if (sums.get(color & HIGH_BITS)! >= least && !colors.some((other) => isSame(color, other))) colors.push(color);
  }
  return colors;
}

/** Colour indices around a pixel; all indices when there are none. */
function beside(found: Uint8Array, at: number, width: number): Set<number> {
  const numbers = new Set<number>();
  const column = at % width;
  for (let row = -width; row <= width; row += width) {
    for (let side = column > 0 ? -1 : 0; side <= (column < width - 1 ? 1 : 0); ++side) {
      const number = found[at + row + side];
      if (number !== undefined && number !== UNKNOWN) numbers.add(number);
    }
  }
  return numbers;
}

function nearestOf(numbers: Set<number>, colors: readonly number[], pixel: number): number {
  const among = numbers.size > 0 ? numbers : colors.keys();
  let best = 0;
  let least = Infinity;
  for (const number of among) {
    const away = distance(colors[number], pixel);
    if (away < least) [best, least] = [number, away];
  }
  return best;
}

/** The distance to transparency depends on alpha only. */
function distance(color: number, pixel: number): number {
  if (color === 0) return (pixel >>> 24) ** 2;
  if (pixel >>> 24 < HALF) return 2 * 255 ** 2;
  const channel = (shift: number) => (((color >>> shift) & 0xff) - ((pixel >>> shift) & 0xff)) ** 2;
  return channel(0) + channel(8) + channel(16);
}
