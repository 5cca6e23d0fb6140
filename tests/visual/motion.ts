/** What changed between two pictures that motion does not explain. */
import type { LabPicture } from './lab.ts';

/** Steps of a channel that nobody sees as an edge: by so much lines fade and backdrops differ from row to row. */
const UNSEEN = 10;

/**
 * Areas of one picture whose colour the other has nowhere within `reach` pixels of them. The border is left out as far as
 * that reaches: what is seen there may come from beyond the picture, or go there.
 * @returns pixels of all of them, and of the largest connected one
 */
export function unexplained(a: LabPicture, b: LabPicture, reach: number): { all: number; largest: number } {
  const [from, to] = [a, b].map(({ pixels }) => new Uint32Array(pixels.buffer));
  const sudden = new Set<number>();
  for (let y = reach; y < a.height - reach; y++) {
    for (let x = reach; x < a.width - reach; x++) {
      const pixel = y * a.width + x;
      if (from[pixel] !== to[pixel] && !occursNear(from[pixel], to, pixel, reach, a.width)) sudden.add(pixel);
    }
  }
  return { all: sudden.size, largest: largestArea(sudden, a.width) };
}

/** As {@link unexplained}, both ways: what comes is as sudden as what goes. */
export function suddenChange(a: LabPicture, b: LabPicture, reach: number): { all: number; largest: number } {
  const [gone, come] = [unexplained(a, b, reach), unexplained(b, a, reach)];
  return { all: Math.max(gone.all, come.all), largest: Math.max(gone.largest, come.largest) };
}

function occursNear(color: number, pixels: Uint32Array, pixel: number, reach: number, width: number): boolean {
  for (let row = pixel - reach * width; row <= pixel + reach * width; row += width) {
    for (let at = row - reach; at <= row + reach; at++) if (looksAlike(pixels[at], color)) return true;
  }
  return false;
}

function looksAlike(one: number, other: number): boolean {
  if (one === other) return true;
  return [0, 8, 16, 24].every((bits) => Math.abs(((one >>> bits) & 255) - ((other >>> bits) & 255)) <= UNSEEN);
}

/** Pixels of the largest area that hangs together, over corners too. */
function largestArea(pixels: Set<number>, width: number): number {
  const left = new Set(pixels);
  let largest = 0;
  for (const seed of pixels) {
    if (!left.delete(seed)) continue;
    const area = [seed];
    for (const pixel of area) {
      for (const step of [-width - 1, -width, -width + 1, -1, 1, width - 1, width, width + 1]) {
        if (left.delete(pixel + step)) area.push(pixel + step);
      }
    }
    largest = Math.max(largest, area.length);
  }
  return largest;
}
