/** Finds the colours of a picture. */
import { inPieces, unlessAborted, type Work } from '../../internal.ts';
import type { Picture } from '../../internal.ts';
import { pictureOfFile } from '../draw/import.ts';
import { chromaOf, distance, hexOf, labOfRgb, type Lab } from './color.ts';

/** A colour and the part of the picture that it covers, 0 to 1. */
export interface Found {
  /** `#rrggbb` */
  readonly color: string;
  readonly share: number;
}

/** Pixels along the longer side of the picture that are looked at. */
const SIDE = 256;

/**
 * The colours of a picture in a file, in short tasks.
 * @throws ShapeError if it is no picture or too large; the reason of the signal when it is aborted
 */
export async function colorsOfPicture(file: File, signal: AbortSignal): Promise<Found[]> {
  const { data } = sampled(await pictureOfFile(file));
  return inPieces(unlessAborted(findingColors(data), signal));
}

/** Single pixels of the picture, because means of several pixels would have colours that it does not have. */
function sampled(picture: Picture): ImageData {
  const [x, y, width, height] = picture.box;
  const scale = SIDE / Math.max(width, height);
  const [columns, rows] = [width, height].map((length) => Math.max(1, Math.round(scale * length)));
  const context = new OffscreenCanvas(columns, rows).getContext('2d', { willReadFrequently: true })!;
  context.imageSmoothingEnabled = false;
  context.setTransform(scale, 0, 0, scale, -scale * x, -scale * y);
  picture.draw(context);
  return context.getImageData(0, 0, columns, rows);
}

/** Similar pixels, which differ by less than 8 of 256 steps in each channel. */
interface Bin {
  readonly lab: Lab;
  readonly count: number;
}

const BITS = 5;
const [PIXELS_BETWEEN_YIELDS, BINS_BETWEEN_YIELDS] = [4096, 512];
const MAX_FOUND = 12;
/** Colours closer than this are one. */
const APART = 0.05;
/** A smaller part of the picture may be the mixture of two neighbouring colours along an edge. */
const EDGE = 0.03;
const ROUNDS = 8;
/** Colours count by their chroma and this much more: mixtures at edges are duller than what they mix, and accents are vivid. */
const DULL = 0.03;
const NO_SUMS = [0, 0, 0, 0] as const;

/**
 * The most different colours of a picture, by Lloyd's algorithm (1982) in OKLab. Groups start at the colours that are farthest
 * from all previous ones, by their chroma and the square root of what they cover, so that small vivid areas have a colour of
 * their own. The result is the same for the same pixels.
 * @param data red, green, blue and alpha of each pixel, 0 to 255; pixels that are more transparent than not do not count
 * @returns the colours from that with the largest part on; none if all pixels are transparent
 */
export function* findingColors(data: Uint8ClampedArray): Work<Found[]> {
  const bins = yield* binning(data);
  const total = bins.reduce((sum, { count }) => sum + count, 0);
  let centers = yield* choosing(bins);
  for (let round = 0; round < ROUNDS; round++) centers = yield* moving(centers, bins);
  const shares = centers.map(() => 0);
  for (const { lab, count } of bins) shares[nearest(centers, lab)] += count / total;
  const groups = centers.map((lab, at) => ({ lab, color: hexOf(lab), share: shares[at] }));
  const large = groups.filter(({ share }) => share >= EDGE).map(({ lab }) => lab);
  const found = groups.filter(({ lab, share }) => share >= EDGE || (share > 0 && !isMixture(lab, large)));
  return found.map(({ color, share }) => ({ color, share })).sort((a, b) => b.share - a.share);
}

/** Whether a colour lies between two others. */
function isMixture(lab: Lab, others: readonly Lab[]): boolean {
  return others.some((from) =>
    others.some((to) => from !== to && distance(from, lab) + distance(lab, to) < distance(from, to) + APART / 2),
  );
}

function* binning(data: Uint8ClampedArray): Work<Bin[]> {
  const sums = new Map<number, [red: number, green: number, blue: number, count: number]>();
  for (let at = 0; at < data.length; at += 4) {
    if (at % (4 * PIXELS_BETWEEN_YIELDS) === 0) yield;
    if (data[at + 3] < 128) continue;
    const [red, green, blue] = [data[at], data[at + 1], data[at + 2]];
    const shift = 8 - BITS;
    const key = ((((red >> shift) << BITS) | (green >> shift)) << BITS) | (blue >> shift);
    const sum = sums.get(key);
    if (!sum) sums.set(key, [red, green, blue, 1]);
    else {
      sum[0] += red;
      sum[1] += green;
      sum[2] += blue;
      sum[3]++;
    }
  }
  const bins: Bin[] = [];
  for (const [red, green, blue, count] of sums.values()) {
    if (bins.length % BINS_BETWEEN_YIELDS === 0) yield;
    bins.push({ lab: labOfRgb(red / count, green / count, blue / count), count });
  }
  return bins;
}

/** The bins at which groups start: the largest one, then always that which is farthest from the previous ones. */
function* choosing(bins: readonly Bin[]): Work<Lab[]> {
  const away = bins.map(() => Infinity);
  const centers: Lab[] = [];
  let next = bins.reduce((best, { count }, at) => (count > bins[best].count ? at : best), 0);
  while (centers.length < Math.min(MAX_FOUND, bins.length)) {
    yield;
    const { lab } = bins[next];
    centers.push(lab);
    bins.forEach((bin, at) => (away[at] = Math.min(away[at], distance(lab, bin.lab))));
    const worth = (at: number) =>
      away[at] < APART ? 0 : away[at] ** 2 * Math.sqrt(bins[at].count) * (DULL + chromaOf(bins[at].lab));
    next = away.reduce((best, _, at) => (worth(at) > worth(best) ? at : best), 0);
    if (worth(next) === 0) break;
  }
  return centers;
}

/** Moves each centre to the mean of the bins that are nearest to it. */
function* moving(centers: readonly Lab[], bins: readonly Bin[]): Work<Lab[]> {
  const sums = centers.map((): number[] => [...NO_SUMS]);
  for (const [at, { lab, count }] of bins.entries()) {
    if (at % BINS_BETWEEN_YIELDS === 0) yield;
    const weight = count * (DULL + chromaOf(lab));
    const sum = sums[nearest(centers, lab)];
    [lab.l, lab.a, lab.b, 1].forEach((value, axis) => (sum[axis] += weight * value));
  }
  return sums.map(([l, a, b, weight], at) =>
    weight === 0 ? centers[at] : { l: l / weight, a: a / weight, b: b / weight },
  );
}

function nearest(centers: readonly Lab[], lab: Lab): number {
  let best = 0;
  for (let at = 1; at < centers.length; at++) if (distance(centers[at], lab) < distance(centers[best], lab)) best = at;
  return best;
}
