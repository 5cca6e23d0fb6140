/**
 * The surface of a puff as points, grouped into patches with bounds, so that a query over all points (such as the
 * farthest lit one) visits few patches.
 */
import { CREASE_FILLET, middleOf } from '../normals.ts';
import { softNormal } from '../softNormal.ts';
import type { Lobe } from '../shapes.ts';
import { lengthOf, minus, normalized, spherePoint, type Vector } from '../vector.ts';

/** Floats per point of a patch: unit normal, position in particle radii, length of the position. */
export const POINT_STRIDE = 7;

/** A group of nearby points and their bounds. */
export interface Patch {
  readonly points: Float32Array;
  /** Unit vector within `normalSpread` (radians) of every normal. */
  readonly normal: Vector;
  readonly normalSpread: number;
  /** Point within `radius` of every position. */
  readonly center: Vector;
  readonly radius: number;
}

/** Spacing of the points on lobes, in particle radii. */
const LOBE_SPACING = 0.026;
/** Boxes along each axis that group the points of a lobe. */
const LOBE_BOXES = 5;

/** The exposed surface of a lobe puff: all points that are not inside another lobe. */
export function surfaceOf(lobes: readonly Lobe[]): Patch[] {
  const middle = middleOf(lobes);
  return lobes.flatMap((lobe) => {
    const boxes: number[][] = [];
    const near = lobes.filter((other) => other === lobe || gapBetween(lobe, other) < CREASE_FILLET);
    const others = near.filter((other) => other !== lobe);
    const count = Math.ceil((4 * Math.PI * lobe.radius ** 2) / LOBE_SPACING ** 2);
    for (let index = 0; index < count; index++) {
      const out = spherePoint(index, count);
      const p = along(lobe, out);
      if (isCovered(p, others)) continue;
      const [nx, ny, nz] = softNormal(near, middle, p);
      (boxes[boxOf(out)] ??= []).push(nx, ny, nz, p[0], p[1], p[2], lengthOf(p));
    }
    return Object.values(boxes).map((points) => bounded(Float32Array.from(points)));
  });
}

/** Gap between two spheres; negative if they overlap. */
function gapBetween(a: Lobe, b: Lobe): number {
  return lengthOf(minus(a.center, b.center)) - a.radius - b.radius;
}

function along({ center, radius }: Lobe, out: Vector): Vector {
  return [center[0] + radius * out[0], center[1] + radius * out[1], center[2] + radius * out[2]];
}

function isCovered(p: Vector, others: readonly Lobe[]): boolean {
  for (let index = 0; index < others.length; index++) {
    const { center, radius } = others[index];
    const x = p[0] - center[0];
    const y = p[1] - center[1];
    const z = p[2] - center[2];
    if (Math.sqrt(x * x + y * y + z * z) < radius) return true;
  }
  return false;
}

function boxOf([x, y, z]: Vector): number {
  return (boxAlong(x) * LOBE_BOXES + boxAlong(y)) * LOBE_BOXES + boxAlong(z);
}

function boxAlong(at: number): number {
  return Math.min(LOBE_BOXES - 1, Math.floor((at + 1) * 0.5 * LOBE_BOXES));
}

/** Computes the bounds of points. */
export function bounded(points: Float32Array): Patch {
  const axis = normalized(mean(points, 0));
  const center = mean(points, 3);
  let cosine = 1;
  let radius = 0;
  for (let i = 0; i < points.length; i += POINT_STRIDE) {
    cosine = Math.min(cosine, points[i] * axis[0] + points[i + 1] * axis[1] + points[i + 2] * axis[2]);
    const [x, y, z] = [points[i + 3] - center[0], points[i + 4] - center[1], points[i + 5] - center[2]];
    radius = Math.max(radius, Math.sqrt(x * x + y * y + z * z));
  }
  return { points, normal: axis, normalSpread: Math.acos(Math.max(-1, cosine)), center, radius };
}

function mean(points: Float32Array, offset: number): Vector {
  let [x, y, z] = [0, 0, 0];
  for (let i = offset; i < points.length; i += POINT_STRIDE) {
    x += points[i];
    y += points[i + 1];
    z += points[i + 2];
  }
  const count = points.length / POINT_STRIDE;
  return [x / count, y / count, z / count];
}
