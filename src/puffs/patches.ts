/**
 * The surface of a puff as points, gathered in patches with bounds, so that a question about all points ("which lit one
 * lies farthest behind?") needs to look into few patches: of baked layers the visible front, of lobes all of it.
 */
import { samplePuff, type PuffLayers, type PuffSample } from './layers.ts';
import { CREASE_FILLET, middleOf, softNormal } from './normals.ts';
import type { Lobe } from './shapes.ts';
import { dot, lengthOf, minus, normalized, spherePoint, type Vector } from './vector.ts';

/** Numbers a point in a patch: normal (unit), position (particle radii), length of the position. */
export const POINT_STRIDE = 7;

/** A few points close to each other, and what bounds them. */
export interface Patch {
  readonly points: Float32Array;
  /** Unit vector within `normalSpread` (radians) of each normal. */
  readonly normal: Vector;
  readonly normalSpread: number;
  /** Within `radius` of each position. */
  readonly center: Vector;
  readonly radius: number;
}

/** Texels along each side of a patch. */
const PATCH_TEXELS = 8;
/** Neighbouring texels whose normals differ by more than this (cosine) are a crease or a rim. */
const SMOOTH_COSINE = 0.985;
/** Points between four texels, along x and along y, where the filter turns across a crease. */
const CREASE_POINTS = 3;
/** Between the points on lobes, particle radii. */
const LOBE_SPACING = 0.026;
/** Boxes along each axis that a lobe's points are gathered in. */
const LOBE_BOXES = 5;

/** The fronts of all layers. */
export function frontsOf(layers: PuffLayers): Patch[][] {
  return Array.from({ length: layers.count }, (_, layer) => frontOf(layers, layer));
}

/** The front of a layer's puff, dense enough where filtering bends normals between texels. */
function frontOf(layers: PuffLayers, layer: number): Patch[] {
  const patches: Patch[] = [];
  for (let j = 0; j < layers.size - 1; j += PATCH_TEXELS) {
    for (let i = 0; i < layers.size - 1; i += PATCH_TEXELS) {
      const points = pointsIn(layers, layer, i, j);
      if (points.length > 0) patches.push(bounded(Float32Array.from(points)));
    }
  }
  return patches;
}

/** All of the surface that some eye can see of a puff of lobes. */
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

/** Between two spheres; negative where they overlap. */
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

function pointsIn(layers: PuffLayers, layer: number, firstI: number, firstJ: number): number[] {
  const { size, pad } = layers;
  const texel = (2 * pad) / size;
  const points: number[] = [];
  for (let j = firstJ; j < Math.min(size - 1, firstJ + PATCH_TEXELS); j++) {
    for (let i = firstI; i < Math.min(size - 1, firstI + PATCH_TEXELS); i++) {
      addPoints(layers, layer, (i + 0.5) * texel - pad, (j + 0.5) * texel - pad, points);
    }
  }
  return points;
}

/** Adds the points between the four texel centres from (x, y) up, as far as they lie on the puff. */
function addPoints(layers: PuffLayers, layer: number, x: number, y: number, points: number[]): void {
  const texel = (2 * layers.pad) / layers.size;
  const corners = [0, 1, 2, 3].map((k) => samplePuff(layers, layer, x + (k & 1) * texel, y + (k >> 1) * texel));
  if (corners.every(({ distance }) => distance > 0)) return;
  const steps = isSmooth(corners) ? 1 : CREASE_POINTS;
  for (let k = 0; k < steps * steps; k++) {
    const px = x + ((k % steps) + 0.5) * (texel / steps);
    const py = y + (Math.floor(k / steps) + 0.5) * (texel / steps);
    const { normal, height, distance } = samplePuff(layers, layer, px, py);
    if (distance <= texel / 2) points.push(...normal, px, py, height, Math.hypot(px, py, height));
  }
}

function isSmooth(corners: readonly PuffSample[]): boolean {
  return corners.every((a) => corners.every((b) => dot(a.normal, b.normal) > SMOOTH_COSINE));
}

function bounded(points: Float32Array): Patch {
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
