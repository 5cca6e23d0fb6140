/** A picture in few flat colours, by their numbers. */
export interface Labels {
  readonly width: number;
  readonly height: number;
  /** Number of the colour of each pixel, row by row; 0 is nothing. */
  readonly of: Uint8Array;
  /** As 0xAABBGGRR, by number; the first is nothing. */
  readonly colors: readonly number[];
}

/** A colour with fewer pixels is taken for a smoothed edge. */
const MIN_SHARE = 1 / 20_000;
const MIN_PIXELS = 4;
const MAX_COLORS = 64;
const HALF = 128;

/**
 * Gives each pixel one of the commonest colours, exactly as they are. Pixels of smoothed edges go over to the nearest of the
 * flat colours beside them, so that no rim of a third colour stands between two.
 */
export function labelColors({ data, width, height }: ImageData): Labels {
  const pixels = new Uint32Array(data.buffer);
  const colors = commonestColors(pixels);
  const numbers = new Map(colors.map((color, number) => [color, number]));
  const found = Uint8Array.from(pixels, (pixel) => numbers.get(settled(pixel)) ?? UNKNOWN);
  const labels = { width, height, of: found.slice(), colors };
  for (let at = 0; at < found.length; ++at) {
    if (found[at] === UNKNOWN) labels.of[at] = nearestOf(beside(found, at, width), colors, pixels[at]);
  }
  return labels;
}

const UNKNOWN = 255;

/** A pixel of full alpha as it is, nothing as 0; half of a pixel is an edge. */
function settled(pixel: number): number {
  const alpha = pixel >>> 24;
  return alpha === 0 ? 0 : alpha === 255 ? pixel : 1;
}

function commonestColors(pixels: Uint32Array): number[] {
  const counts = new Map<number, number>();
  for (const pixel of pixels) {
    const color = settled(pixel);
    if (color > 1) counts.set(color, (counts.get(color) ?? 0) + 1);
  }
  const least = Math.max(MIN_PIXELS, MIN_SHARE * pixels.length);
  const common = [...counts].filter(([, count]) => count >= least).sort(([, a], [, b]) => b - a);
  return [0, ...common.slice(0, MAX_COLORS).map(([color]) => color)];
}

/** Numbers of the colours around a pixel; all of them where none is around it. */
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

/** What lies before nothing differs from it by its alpha alone. */
function distance(color: number, pixel: number): number {
  if (color === 0) return (pixel >>> 24) ** 2;
  if (pixel >>> 24 < HALF) return 2 * 255 ** 2;
  const channel = (shift: number) => (((color >>> shift) & 0xff) - ((pixel >>> shift) & 0xff)) ** 2;
  return channel(0) + channel(8) + channel(16);
}
