import { GIFEncoder, quantize } from 'gifenc';
import { requireShape, type ClipFile, type ClipShape } from './clipFile.ts';

const FOREVER = 0;
/** GIF disposal method: clears the previous frame, which would otherwise show through transparent pixels. */
const RESTORE_BACKGROUND = 2;

/** Encodes with up to 256 colours for each frame, and pixels that are either opaque or transparent. */
export class Gif implements ClipFile {
  private readonly shape: ClipShape;
  private readonly encoder = GIFEncoder();
  private frames = 0;

  /** @throws RangeError for a size or a rate that is not accepted */
  constructor(shape: ClipShape) {
    requireShape(shape);
    this.shape = shape;
  }

  add(pixels: Uint8ClampedArray<ArrayBuffer>): Promise<void> {
    const { width, height, rate } = this.shape;
    const { palette, indices, transparent } = indexFrame(pixels);
    this.encoder.writeFrame(indices, width, height, {
      palette,
      delay: delayOf(this.frames++, rate),
      repeat: FOREVER,
      transparent: transparent !== undefined,
      transparentIndex: transparent ?? 0,
      dispose: transparent === undefined ? -1 : RESTORE_BACKGROUND,
    });
    return Promise.resolve();
  }

  finish(): Blob {
    this.encoder.finish();
    return new Blob([this.encoder.bytes()], { type: 'image/gif' });
  }
}

/** Delay of a frame in milliseconds, a multiple of 10. Rounding errors do not accumulate over frames. */
function delayOf(frame: number, rate: number): number {
  const until = (count: number) => Math.round((100 * count) / rate);
  return 10 * (until(frame + 1) - until(frame));
}

const MAX_COLORS = 256;
/** Palette entries reserved for the most common colours, which stay exact: flat tones, ink and backdrop rows. */
const EXACT = 208;
/** Pixels with less alpha become transparent, because a GIF has no partial transparency. */
const HALF = 128;

/** A GIF frame: a palette of up to 256 colours and one index per pixel. */
interface IndexedFrame {
  readonly palette: number[][];
  readonly indices: Uint8Array;
  /** Index of the transparent colour; undefined when the frame is opaque. */
  readonly transparent: number | undefined;
}

/**
 * Converts a frame to indexed colour. The most common colours stay exact; an ordinary quantizer would mix them with
 * similar ones. Rare colours, mostly on antialiased edges, map to the nearest colour of a palette that is quantized
 * from the rest.
 */
export function indexFrame({ buffer }: Uint8ClampedArray<ArrayBuffer>): IndexedFrame {
  const pixels = new Uint32Array(buffer);
  const counts = countColors(pixels);
  const hasHoles = counts.delete(0);
  const capacity = MAX_COLORS - Number(hasHoles);
  const ordered = [...counts.keys()].sort((a, b) => counts.get(b)! - counts.get(a)!);
  const exact = ordered.length <= capacity ? ordered : ordered.slice(0, EXACT);
  const rest = ordered.slice(exact.length);
  const palette = [...exact.map(channels), ...mixtures(rest, capacity - exact.length)];
  const numbers = new Map(exact.map((color, number) => [color, number]));
  for (const color of rest) numbers.set(color, nearest(palette, channels(color)));
  const transparent = hasHoles ? palette.length : undefined;
  if (hasHoles) {
    numbers.set(0, palette.length);
    palette.push([0, 0, 0]);
  }
  return { palette, indices: Uint8Array.from(pixels, (pixel) => numbers.get(opaque(pixel))!), transparent };
}

/**
 * Returns the pixel with full alpha, or 0 when it is transparent. Opaque black includes its alpha, so it differs from
 * 0.
 */
function opaque(pixel: number): number {
  return pixel >>> 24 < HALF ? 0 : (pixel | 0xff000000) >>> 0;
}

function countColors(pixels: Uint32Array): Map<number, number> {
  const counts = new Map<number, number>();
  for (const pixel of pixels) {
    const color = opaque(pixel);
    counts.set(color, (counts.get(color) ?? 0) + 1);
  }
  return counts;
}

function channels(color: number): number[] {
  return [color & 0xff, (color >> 8) & 0xff, (color >> 16) & 0xff];
}

function mixtures(colors: readonly number[], count: number): number[][] {
  if (colors.length === 0 || count === 0) return [];
  return quantize(new Uint8Array(Uint32Array.from(colors).buffer), count);
}

function nearest(palette: readonly number[][], [red, green, blue]: readonly number[]): number {
  let best = 0;
  let least = Infinity;
  palette.forEach((entry, number) => {
    const away = (entry[0] - red) ** 2 + (entry[1] - green) ** 2 + (entry[2] - blue) ** 2;
    if (away < least) [best, least] = [number, away];
  });
  return best;
}
