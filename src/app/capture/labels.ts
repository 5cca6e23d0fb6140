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
  const numbers = new Map(colors.map((color, number) => [color, number]));
  const found = Uint8Array.from(pixels, (pixel) => numbers.get(settled(pixel)) ?? UNKNOWN);
  const labels = { width, height, of: found.slice(), colors };
  for (let at = 0; at < found.length; ++at) {
    if (found[at] === UNKNOWN) labels.of[at] = nearestOf(beside(found, at, width), colors, pixels[at]);
  }
  return labels;
}

const UNKNOWN = 255;

/** Returns opaque pixels unchanged, transparent ones as 0 and partially transparent ones as 1, which marks an edge. */
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
