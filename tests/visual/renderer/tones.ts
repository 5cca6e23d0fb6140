/** Measures of the regions of one tone in a picture of smoke. */

/** Areas of small regions, pixels: from, to. */
const SMALL = [4, 59] as const;
/** Area from which a region that appears at once is noticed, pixels. */
const NOTICED = 13;
/** Areas of crumbs, pixels: from, to. */
const CRUMB = [4, 499] as const;

/** The tone of each pixel of smoke, any numbers; {@link NO_SMOKE} elsewhere. */
export interface Tones {
  readonly width: number;
  readonly height: number;
  readonly tones: Int32Array;
}

export const NO_SMOKE = -1;

/** Connected pixels of one tone. */
export interface Region {
  readonly tone: number;
  readonly pixels: readonly number[];
}

/** The regions of a picture: 4-connected pixels of one tone. */
export function regionsOf({ width, height, tones }: Tones): Region[] {
  const left = Uint8Array.from(tones, (tone) => Number(tone !== NO_SMOKE));
  const regions: Region[] = [];
  for (let seed = 0; seed < tones.length; seed++) {
    if (!left[seed]) continue;
    left[seed] = 0;
    const pixels = [seed];
    for (const pixel of pixels) {
      for (const next of neighbours(pixel, width, height)) {
        if (!left[next] || tones[next] !== tones[seed]) continue;
        left[next] = 0;
        pixels.push(next);
      }
    }
    regions.push({ tone: tones[seed], pixels });
  }
  return regions;
}

/** Number of regions with an area of 4 to 59 pixels. */
export function countSmall(regions: readonly Region[]): number {
  return regions.filter(({ pixels }) => pixels.length >= SMALL[0] && pixels.length <= SMALL[1]).length;
}

/** Number of crumbs: pieces of the smoke's silhouette of 4 to 499 pixels, without the largest piece. */
export function countCrumbs({ width, height, tones }: Tones): number {
  const silhouette = tones.map((tone) => (tone === NO_SMOKE ? NO_SMOKE : 0));
  const sizes = regionsOf({ width, height, tones: silhouette }).map(({ pixels }) => pixels.length);
  const [, ...apart] = sizes.toSorted((a, b) => b - a);
  return apart.filter((size) => size >= CRUMB[0] && size <= CRUMB[1]).length;
}

/** Pairs of neighbouring pixels of smoke with different tones: the length of the border between tones. */
export function borderOf({ width, height, tones }: Tones): number {
  let border = 0;
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const pixel = y * width + x;
      if (tones[pixel] === NO_SMOKE) continue;
      if (x + 1 < width) border += Number(differs(tones[pixel], tones[pixel + 1]));
      if (y + 1 < height) border += Number(differs(tones[pixel], tones[pixel + width]));
    }
  }
  return border;
}

function differs(tone: number, other: number): boolean {
  return other !== NO_SMOKE && other !== tone;
}

/** Share of the pixels that are smoke in both pictures and have another tone in the second. */
export function flipsBetween(before: Tones, now: Tones): number {
  let [both, flips] = [0, 0];
  before.tones.forEach((tone, pixel) => {
    if (tone === NO_SMOKE || now.tones[pixel] === NO_SMOKE) return;
    both++;
    if (now.tones[pixel] !== tone) flips++;
  });
  return both === 0 ? 0 : flips / both;
}

/**
 * Number of regions of more than 12 pixels that appear at once: nothing of their tone was at any of their pixels, or
 * within `reach` pixels of them, and most of them were smoke before.
 * @param reach how far smoke moves between the pictures, pixels
 */
export function birthsBetween(before: Tones, now: Tones, reach: number): number {
  return regionsOf(now).filter(({ tone, pixels }) => {
    if (pixels.length < NOTICED) return false;
    const covered = pixels.filter((pixel) => before.tones[pixel] !== NO_SMOKE).length;
    return covered > pixels.length / 2 && !pixels.some((pixel) => isNear(before, pixel, tone, reach));
  }).length;
}

function isNear({ width, height, tones }: Tones, pixel: number, tone: number, reach: number): boolean {
  const [column, row] = [pixel % width, Math.floor(pixel / width)];
  for (let y = Math.max(0, row - reach); y <= Math.min(height - 1, row + reach); y++) {
    for (let x = Math.max(0, column - reach); x <= Math.min(width - 1, column + reach); x++) {
      if (tones[y * width + x] === tone) return true;
    }
  }
  return false;
}

function neighbours(pixel: number, width: number, height: number): number[] {
  const x = pixel % width;
  const found = [];
  if (x > 0) found.push(pixel - 1);
  if (x + 1 < width) found.push(pixel + 1);
  if (pixel >= width) found.push(pixel - width);
  if (pixel + width < width * height) found.push(pixel + width);
  return found;
}
