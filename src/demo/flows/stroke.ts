/** From a stroke on the picture to the points of a flow. */
import type { Stage } from '../../index.ts';
import { MAX_POINTS, type PathPoint } from '../../internal.ts';
import { depthAt, placeAt, type PicturePlace } from './depth.ts';

/** Distance between the ends of a stroke that is a ring, CSS pixels. */
const CLOSING = 28;
/** Largest deviation of a simplified stroke, CSS pixels, at first. */
const DEVIATION = 2.5;
/** Strokes that are shorter are clicks, CSS pixels. */
const SHORTEST = 24;

/** What a stroke becomes. */
export interface DrawnFlow {
  readonly points: readonly PathPoint[];
  readonly isClosed: boolean;
  /** Metres for a CSS pixel, on average. */
  readonly metres: number;
  /** Metres. */
  readonly length: number;
}

/**
 * The points of a flow in world space. They are as far away as what lies under the ends of the stroke.
 * @param keepsAll whether all places become points, instead of the few that describe the stroke
 * @returns undefined for a click
 */
export function flowOf(stage: Stage, stroke: readonly PicturePlace[], keepsAll = false): DrawnFlow | undefined {
  const ways = lengths(stroke);
  const total = ways.at(-1) ?? 0;
  if (total < SHORTEST) return undefined;
  const [first, last] = [stroke[0], stroke.at(-1)!];
  const isClosed = total > 4 * CLOSING && distance(first, last) < CLOSING;
  const kept = keepsAll ? stroke.map((_, index) => index) : simplified(isClosed ? stroke.slice(0, -1) : stroke);
  const depths = [first, isClosed ? first : last].map((place) => depthAt(stage, place));
  const points = kept.map((index): PathPoint => {
    const share = ways[index] / total;
    // Depths whose inverse is linear: a straight stroke stays straight, and on the ground if its ends are there.
    const depth = 1 / ((1 - share) / depths[0] + share / depths[1]);
    return placeAt(stage, stroke[index], depth).map(round) as unknown as PathPoint;
  });
  const metres = points.slice(1).reduce((sum, point, index) => sum + away(point, points[index]), 0);
  return { points, isClosed, metres: metres / total, length: metres };
}

/** The distances along a stroke from its start. */
function lengths(stroke: readonly PicturePlace[]): number[] {
  let sum = 0;
  return stroke.map((place, index) => (sum += index > 0 ? distance(place, stroke[index - 1]) : 0));
}

function distance(a: PicturePlace, b: PicturePlace): number {
  return Math.hypot(a.x - b.x, a.y - b.y);
}

function away(a: PathPoint, b: PathPoint): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/** Indices of the places that describe a stroke, by Ramer, Douglas and Peucker, as many as a flow may have. */
export function simplified(stroke: readonly PicturePlace[], most = MAX_POINTS): number[] {
  for (let deviation = DEVIATION; ; deviation *= 1.5) {
    const kept = [0, ...between(stroke, 0, stroke.length - 1, deviation), stroke.length - 1];
    if (kept.length <= most) return kept;
  }
}

function between(stroke: readonly PicturePlace[], from: number, to: number, deviation: number): number[] {
  let [farthest, most] = [0, deviation];
  for (let index = from + 1; index < to; ++index) {
    const off = offLine(stroke[index], stroke[from], stroke[to]);
    if (off > most) [farthest, most] = [index, off];
  }
  if (farthest === 0) return [];
  return [...between(stroke, from, farthest, deviation), farthest, ...between(stroke, farthest, to, deviation)];
}

function offLine(place: PicturePlace, from: PicturePlace, to: PicturePlace): number {
  const length = distance(from, to);
  if (length === 0) return distance(place, from);
  return Math.abs((to.x - from.x) * (place.y - from.y) - (to.y - from.y) * (place.x - from.x)) / length;
}

function round(metres: number): number {
  return Math.round(metres * 1000) / 1000 + 0;
}
