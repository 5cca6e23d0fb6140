/** Turns pictures, SVG files and letters into sketches. */
import { ShapeError } from '../../index.ts';
import { MAX_DRAWINGS, pictureOfSvg, SIDE, type Picture } from '../../internal.ts';
import { strings } from '../strings.ts';
import { COLORS, emptySketch, isOnPaper, PAPER, withoutSpecks, type Sketch } from './sketch.ts';

export const PICTURE_TYPES = '.png,.svg';
const MAX_BYTES = 32 * 1024 * 1024;
const MAX_PIXELS = 8192;

/** @throws ShapeError if the file is no picture, too large or empty */
export async function sketchOfFile(file: File): Promise<Sketch> {
  return naming(file, async () => sketchOfPixels(fitted(await pictureOfFile(file))));
}

/** A sketch for each of the first letters of a text, in one colour. */
export function sketchesOfText(text: string, ink: number): Sketch[] {
  const letters = Array.from(text.replaceAll(/\s/g, '')).slice(0, MAX_DRAWINGS);
  return letters.map((each) => {
    const { data } = fitted(letter(each));
    const pixels = Uint8Array.from({ length: SIDE * SIDE }, (_, at) => (isInside(data, at) ? ink : 0));
    return { ...emptySketch(), pixels };
  });
}

/** Adds the name of a file to what is wrong with it. */
async function naming<Result>(file: File, read: () => Promise<Result>): Promise<Result> {
  try {
    return await read();
  } catch (error) {
    throw new ShapeError(strings.files.rejected(file.name, (error as Error).message), { cause: error });
  }
}

/** @throws ShapeError if the file is too large or no picture that the browser reads */
export async function pictureOfFile(file: File): Promise<Picture> {
  if (file.size > MAX_BYTES) throw new ShapeError(strings.files.tooLarge(MAX_BYTES / 1024 / 1024));
  return /\.svg$/i.test(file.name) ? pictureOfSvg(await file.text()) : bitmapOf(file);
}

async function bitmapOf(file: File): Promise<Picture> {
  const isPng = /\.png$/i.test(file.name);
  // The size of a PNG is in its first chunk, so that a large one is not decoded.
  const head = new DataView(await file.slice(0, 24).arrayBuffer());
  if (isPng && (head.byteLength < 24 || head.getUint32(0) !== 0x89504e47)) {
    throw new ShapeError(strings.drawing.notPng);
  }
  if (isPng) requireSize(head.getUint32(16), head.getUint32(20));
  const bitmap = await createImageBitmap(file).catch(() => {
    throw new ShapeError(isPng ? strings.drawing.notPng : strings.drawing.notPicture);
  });
  const { width, height } = bitmap;
  requireSize(width, height);
  return { box: [0, 0, width, height], draw: (context) => context.drawImage(bitmap, 0, 0) };
}

function requireSize(width: number, height: number): void {
  if (Math.max(width, height) > MAX_PIXELS) throw new ShapeError(strings.drawing.tooManyPixels(MAX_PIXELS));
}

function letter(text: string): Picture {
  return {
    box: [-SIDE / 2, -SIDE / 2, SIDE, SIDE],
    draw(context) {
      context.fillStyle = '#ffffff';
      context.font = `900 ${0.7 * SIDE}px ${getComputedStyle(document.documentElement).getPropertyValue('--lettering')}`;
      context.textAlign = 'center';
      context.textBaseline = 'middle';
      context.fillText(text, 0, 0);
    },
  };
}

/** Draws a picture twice: to find what it covers, and then so that this just fits on the paper. */
function fitted(picture: Picture): ImageData {
  const [x, y, width, height] = picture.box;
  const context = new OffscreenCanvas(SIDE, SIDE).getContext('2d', { willReadFrequently: true })!;
  const drawn = (scale: number, middleX: number, middleY: number): ImageData => {
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, SIDE, SIDE);
    context.setTransform(scale, 0, 0, scale, SIDE / 2 - scale * middleX, SIDE / 2 - scale * middleY);
    picture.draw(context);
    return context.getImageData(0, 0, SIDE, SIDE);
  };
  const scale = SIDE / Math.max(width, height);
  const [middleX, middleY] = [x + width / 2, y + height / 2];
  const { data } = drawn(scale, middleX, middleY);
  const covered = [...Array(SIDE * SIDE).keys()].filter((at) => isInside(data, at));
  if (covered.length === 0) throw new ShapeError(strings.drawing.nothing);
  const [columns, rows] = [covered.map((at) => at % SIDE), covered.map((at) => Math.floor(at / SIDE))];
  const [centerX, centerY] = [middleOf(columns), middleOf(rows)];
  const reach = covered.reduce(
    (most, _, at) => Math.max(most, Math.hypot(columns[at] - centerX, rows[at] - centerY)),
    1,
  );
  return drawn(
    (scale * (PAPER - 1)) / reach,
    middleX + (centerX + 0.5 - SIDE / 2) / scale,
    middleY + (centerY + 0.5 - SIDE / 2) / scale,
  );
}

function middleOf(places: readonly number[]): number {
  const [low, high] = places.reduce(([a, b], place) => [Math.min(a, place), Math.max(b, place)], [SIDE, 0]);
  return (low + high) / 2;
}

function isInside(data: Uint8ClampedArray, at: number): boolean {
  return data[4 * at + 3] > 127 && isOnPaper((at % SIDE) + 0.5, Math.floor(at / SIDE) + 0.5);
}

function sketchOfPixels(image: ImageData): Sketch {
  const { values, colors } = quantized(image);
  const unused = COLORS.filter((color) => !colors.includes(color));
  // Black would hide all tones of the style, so that pictures in black alone become white.
  const own = colors.length === 1 && luminanceOf(colors[0]) < 0.05 ? [COLORS[0]] : colors;
  return {
    ...emptySketch(),
    pixels: withoutSpecks(withoutSpecks(values)),
    colors: [...own, ...unused].slice(0, COLORS.length),
  };
}

type Rgb = readonly [red: number, green: number, blue: number];

/** Distance below which two colours are one. */
const SAME = 40;
/** Part of the picture that a colour needs. */
const LEAST = 0.004;
const ROUNDS = 6;

/** Reduces a picture to its most frequent colours, by Lloyd's algorithm (1982). */
function quantized({ data }: ImageData): { values: Uint8Array; colors: string[] } {
  const inside = [...Array(SIDE * SIDE).keys()].filter((at) => isInside(data, at));
  if (inside.length === 0) throw new ShapeError(strings.drawing.nothing);
  const colorAt = (at: number): Rgb => [data[4 * at], data[4 * at + 1], data[4 * at + 2]];
  const bins = new Map<number, number>();
  for (const at of inside) {
    const bin = colorAt(at).reduce((sum, share) => 16 * sum + (share >> 4), 0);
    bins.set(bin, (bins.get(bin) ?? 0) + 1);
  }
  const frequent = [...bins].filter(([, count]) => count >= LEAST * inside.length || bins.size === 1);
  frequent.sort(([a, some], [b, others]) => others - some || a - b);
  let means: Rgb[] = [];
  for (const [bin] of frequent.length > 0 ? frequent : bins) {
    const color: Rgb = [16 * (bin >> 8) + 8, 16 * ((bin >> 4) & 15) + 8, 16 * (bin & 15) + 8];
    if (means.length < COLORS.length && means.every((mean) => away(mean, color) > SAME)) means.push(color);
  }
  for (let round = 0; round < ROUNDS; round++) {
    const sums = means.map(() => [0, 0, 0, 0]);
    for (const at of inside) {
      const color = colorAt(at);
      const sum = sums[nearest(means, color)];
      color.forEach((share, channel) => (sum[channel] += share));
      sum[3]++;
    }
    means = means.map((mean, at) => {
      const [red, green, blue, count] = sums[at];
      return count === 0 ? mean : [red / count, green / count, blue / count];
    });
  }
  const values = new Uint8Array(SIDE * SIDE);
  for (const at of inside) values[at] = nearest(means, colorAt(at)) + 1;
  return { values, colors: means.map(hexOf) };
}

function away(a: Rgb, b: Rgb): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

function nearest(means: readonly Rgb[], color: Rgb): number {
  return means.reduce((best, mean, at) => (away(mean, color) < away(means[best], color) ? at : best), 0);
}

function hexOf(color: Rgb): string {
  return `#${color.map((share) => Math.round(share).toString(16).padStart(2, '0')).join('')}`;
}

/** Perceived brightness of a colour, 0..1. */
function luminanceOf(color: string): number {
  const [red, green, blue] = [1, 3, 5].map((at) => parseInt(color.slice(at, at + 2), 16) / 255);
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}
