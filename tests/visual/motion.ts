/** Changes between two pictures that motion does not explain. */
import type { LabPicture } from './lab.ts';

/** Largest invisible difference of a channel: faded lines and gradient backdrops differ by this from row to row. */
const UNSEEN = 10;

/** Which changes motion explains. */
export interface Explained {
  /** A colour may move this far between the pictures, pixels. */
  reach: number;
  /**
   * A strip of up to `width` pixels may appear from behind a moving edge in a new colour. Ink lines are as thin and
   * always count.
   */
  strip?: { width: number; ink: number };
  /** Where lines blend into the colour of their smoke, by pixel: ink appears and vanishes gradually there. */
  paling?: { where: Uint8Array; ink: number };
  /** Pixels to ignore. */
  besides?: ReadonlySet<number>;
}

/**
 * Areas of one picture whose colour does not occur in the other one within `reach` pixels. A border of `reach` pixels
 * is ignored, because its content may come from outside the picture or move there.
 * @returns pixels of all areas, and of the largest connected one
 */
export function unexplained(a: LabPicture, b: LabPicture, explained: Explained): { all: number; largest: number } {
  const { strip } = explained;
  const areas = areasOf(suddenPixels(a, b, explained), a.width).map((area) =>
    strip ? withoutStrips(area, new Uint32Array(a.pixels.buffer), strip, a.width) : area.length,
  );
  return { all: areas.reduce((sum, area) => sum + area, 0), largest: Math.max(0, ...areas) };
}

/** The pixels of those areas, including strips. */
export function suddenPixels(
  a: LabPicture,
  b: LabPicture,
  { reach, paling, besides }: Omit<Explained, 'strip'>,
): Set<number> {
  const [from, to] = [a, b].map(({ pixels }) => new Uint32Array(pixels.buffer));
  const sudden = new Set<number>();
  for (let y = reach; y < a.height - reach; y++) {
    for (let x = reach; x < a.width - reach; x++) {
      const pixel = y * a.width + x;
      if (from[pixel] === to[pixel] || besides?.has(pixel)) continue;
      const ink = paling?.where[pixel] ? paling.ink : undefined;
      if (!occursNear(from[pixel], to, pixel, { reach, ink, width: a.width })) sudden.add(pixel);
    }
  }
  return sudden;
}

/** {@link unexplained} in both directions: areas that appear and areas that vanish. */
export function suddenChange(a: LabPicture, b: LabPicture, explained: Explained): { all: number; largest: number } {
  const [gone, come] = [unexplained(a, b, explained), unexplained(b, a, explained)];
  return { all: Math.max(gone.all, come.all), largest: Math.max(gone.largest, come.largest) };
}

interface Search {
  reach: number;
  /** An ink colour that may cover the colour with any share. */
  ink: number | undefined;
  width: number;
}

function occursNear(color: number, pixels: Uint32Array, pixel: number, { reach, ink, width }: Search): boolean {
  for (let row = pixel - reach * width; row <= pixel + reach * width; row += width) {
    for (let at = row - reach; at <= row + reach; at++) {
      if (looksAlike(pixels[at], color) || (ink !== undefined && isInked(color, pixels[at], ink))) return true;
    }
  }
  return false;
}

function looksAlike(one: number, other: number): boolean {
  if (one === other) return true;
  return [0, 8, 16, 24].every((bits) => Math.abs(((one >>> bits) & 255) - ((other >>> bits) & 255)) <= UNSEEN);
}

/** Whether a colour is another one with more or less ink. */
function isInked(color: number, plain: number, ink: number): boolean {
  const [mixed, from, to] = [color, plain, ink].map(channelsOf);
  const way = to.map((value, channel) => value - from[channel]);
  const along = way.reduce((sum, step, channel) => sum + step * (mixed[channel] - from[channel]), 0);
  const share = Math.min(1, Math.max(0, along / Math.max(1, Math.hypot(...way) ** 2)));
  return from.every((value, channel) => Math.abs(mixed[channel] - value - share * way[channel]) <= UNSEEN);
}

function channelsOf(color: number): number[] {
  return [0, 8, 16, 24].map((bits) => (color >>> bits) & 255);
}

/** Areas of 8-connected pixels. */
function areasOf(pixels: Set<number>, width: number): number[][] {
  const left = new Set(pixels);
  const areas: number[][] = [];
  for (const seed of pixels) {
    if (!left.delete(seed)) continue;
    const area = [seed];
    for (const pixel of area) {
      for (const step of [-width - 1, -width, -width + 1, -1, 1, width - 1, width, width + 1]) {
        if (left.delete(pixel + step)) area.push(pixel + step);
      }
    }
    areas.push(area);
  }
  return areas;
}

/** Pixels of an area, or only those of its ink if the whole area is a thin strip. */
function withoutStrips(
  area: number[],
  colors: Uint32Array,
  strip: { width: number; ink: number },
  row: number,
): number {
  const own = new Set(area);
  const steps = Array.from({ length: strip.width + 1 }, (_, step) => step);
  const isBroad = area.some((corner) => steps.every((y) => steps.every((x) => own.has(corner + y * row + x))));
  return isBroad ? area.length : area.filter((pixel) => looksAlike(colors[pixel], strip.ink)).length;
}
