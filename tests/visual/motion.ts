/** What changed between two pictures that motion does not explain. */
import type { LabPicture } from './lab.ts';

/**
 * Areas of one picture whose colour the other has nowhere within `reach` pixels of them.
 * @returns pixels of all of them, and of the largest connected one
 */
export function unexplained(a: LabPicture, b: LabPicture, reach: number): { all: number; largest: number } {
  const [from, to] = [a, b].map(({ pixels }) => new Uint32Array(pixels.buffer));
  const sudden = new Set<number>();
  for (let pixel = 0; pixel < from.length; pixel++) {
    if (from[pixel] !== to[pixel] && !occursNear(from[pixel], to, pixel, reach, a)) sudden.add(pixel);
  }
  return { all: sudden.size, largest: largestArea(sudden, a.width) };
}

/** As {@link unexplained}, both ways: what comes is as sudden as what goes. */
export function suddenChange(a: LabPicture, b: LabPicture, reach: number): { all: number; largest: number } {
  const [gone, come] = [unexplained(a, b, reach), unexplained(b, a, reach)];
  return { all: Math.max(gone.all, come.all), largest: Math.max(gone.largest, come.largest) };
}

function occursNear(
  color: number,
  pixels: Uint32Array,
  pixel: number,
  reach: number,
  { width, height }: LabPicture,
): boolean {
  const [x, y] = [pixel % width, Math.floor(pixel / width)];
  for (let j = Math.max(0, y - reach); j <= Math.min(height - 1, y + reach); j++) {
    for (let i = Math.max(0, x - reach); i <= Math.min(width - 1, x + reach); i++) {
      if (pixels[j * width + i] === color) return true;
    }
  }
  return false;
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
