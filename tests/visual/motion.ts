/** What changed between two pictures that motion does not explain. */
import type { LabPicture } from './lab.ts';

/** Steps of a channel that nobody sees as an edge: by so much lines fade and backdrops differ from row to row. */
const UNSEEN = 10;

/** What counts as one area of change. */
export interface Explained {
  /** What was so near before may have moved here, pixels. */
  reach: number;
  /**
   * As wide a strip, pixels, may come from behind an edge that moves, in a colour that was seen nowhere before. Lines of ink
   * are as thin and may not: they count however thin they are.
   */
  strip?: { width: number; ink: number };
  /** Where lines go over into the colour of their smoke, by pixels: ink comes and goes by and by there. */
  paling?: { where: Uint8Array; ink: number };
  /** Pixels that are no matter of what is looked at. */
  besides?: ReadonlySet<number>;
}

/**
 * Areas of one picture whose colour the other has nowhere within `reach` pixels of them. The border is left out as far as
 * that reaches: what is seen there may come from beyond the picture, or go there.
 * @returns pixels of all of them, and of the largest connected one
 */
export function unexplained(a: LabPicture, b: LabPicture, explained: Explained): { all: number; largest: number } {
  const { strip } = explained;
  const areas = areasOf(suddenPixels(a, b, explained), a.width).map((area) =>
    strip ? withoutStrips(area, new Uint32Array(a.pixels.buffer), strip, a.width) : area.length,
  );
  return { all: areas.reduce((sum, area) => sum + area, 0), largest: Math.max(0, ...areas) };
}

/** The pixels of those areas, strips among them. */
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

/** As {@link unexplained}, both ways: what comes is as sudden as what goes. */
export function suddenChange(a: LabPicture, b: LabPicture, explained: Explained): { all: number; largest: number } {
  const [gone, come] = [unexplained(a, b, explained), unexplained(b, a, explained)];
  return { all: Math.max(gone.all, come.all), largest: Math.max(gone.largest, come.largest) };
}

interface Search {
  reach: number;
  /** What may have come over a colour, in any measure. */
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

/** Whether a colour is another with more or less ink over it. */
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

/** Areas that hang together, over corners too. */
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

/** Pixels of an area, or those of its ink alone where all of it is a thin strip. */
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
