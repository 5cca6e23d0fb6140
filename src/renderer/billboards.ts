/**
 * Puffs as the paper's billboards, which are pictures of their fronts that face the camera. Few smokes use them, so
 * this module is loaded on demand.
 */
import fragmentShader from '../../shaders/bodies/billboards.frag';
import vertexShader from '../../shaders/bodies/billboards.vert';
import { BillboardTextures } from './gpu/billboardTextures.ts';
import type { BillboardPuffs } from './gpu/puffTextures.ts';
import { FIRST_BORDER } from './gpu/ramps.ts';
import type { Shaders } from './gpu/programsAhead.ts';
import { castersOf } from './puffs/billboards/casters.ts';
import { boundingFront, type BoundedFront } from './puffs/billboards/frontSolids.ts';
import { LruCache } from './puffs/lru.ts';
import {
  bakingLayers,
  samplePuff,
  type Precision,
  type PuffLayers,
  type PuffSample,
} from './puffs/billboards/layers.ts';
import { reachOf } from './puffs/lobes.ts';
import { billboardShapes, hasOnlyFront, isOwnPicture } from './puffs/billboards/sides.ts';
import { keyOf, type Lobe, type PuffShape } from './puffs/shapes.ts';
import { solidsOf, type PuffSolids } from './puffs/bake/solids.ts';
import { bakingTable, joined, latestCap } from './puffs/bake/startCaps.ts';
import { type Work, finished } from '../base/work.ts';
import { bounded, type Patch } from './puffs/bake/patches.ts';
import { dot } from './puffs/vector.ts';

export { makingShapes } from './puffs/drawing/drawPuff.ts';

/** The shaders of billboard bodies. */
export const billboardShaders: Shaders = { vertexShader, fragmentShader };

/** Tolerance of the outline and the relief: in radii for facets, texels and filtering, in pixels for mipmap levels. */
const LAYER_TOLERANCE = 0.06;
const LAYER_BLUR = 3;
/** Tolerance of a silhouette as its layer is filtered, and of its roll in the simulator: a texel, in radii. */
const DISC_TOLERANCE = 0.022;

const cache = new LruCache<BillboardPuffs>(4);

/**
 * Bakes billboards in steps of a few milliseconds, or returns them from the LRU cache.
 * @param shapes viewed from +z
 * @param views number of views of each shape, 1, 2, 4 or 8, evenly spaced around its y axis; one is enough if all shapes
 *   have only a front
 */
export function bakingBillboards(
  shapes: readonly PuffShape[],
  precision: Precision = 16,
  views = 1,
): Work<BillboardPuffs> {
  const sides = shapes.every(hasOnlyFront) ? 1 : views;
  const key = `${precision} ${sides} ${keyOf(shapes)}`;
  return cache.making(key, () => baking(billboardShapes(shapes, sides), precision, sides));
}

function* baking(shapes: readonly PuffShape[], precision: Precision, sides: number): Work<BillboardPuffs> {
  const layers = yield* bakingLayers(shapes, { precision });
  const tables: Float32Array[] = [];
  let latest = 0;
  for (let layer = 0; layer < layers.count; layer++) {
    const front = yield* findingFront(layers, layer);
    tables.push(yield* bakingTable(front, FIRST_BORDER));
    latest = Math.max(latest, latestCap(front));
  }
  const fronts: BoundedFront[] = [];
  for (const [layer, shape] of shapes.entries()) {
    const { lobes } = shape;
    fronts.push(isOwnPicture(shape) ? yield* boundingFront(layers, layer, lobes) : { balls: lobes, deviation: 0 });
  }
  const deviation = Math.max(...fronts.map((front) => front.deviation));
  const casters = castersOf(shapes, layers);
  const data = {
    layers,
    sides,
    startCaps: joined(tables),
    latestCap: latest,
    casters,
    solids: billboardSolids(
      fronts.map(({ balls }) => balls),
      deviation,
    ),
    casterSolids: casters.silhouetteReach > 0 ? discSolids(layers) : billboardSolids(shapes.map(({ lobes }) => lobes)),
    reach: Math.max(...shapes.map(({ lobes }) => reachOf(lobes)), casters.silhouetteReach),
    depth: Math.max(...layers.figures.map(({ depth }) => depth)),
  };
  return { ...data, texturesFor: (context) => new BillboardTextures(context, data) };
}

/** @param deviation of the baked fronts from the balls, in particle radii */
function billboardSolids(balls: readonly (readonly Lobe[])[], deviation = 0): PuffSolids {
  return solidsOf(balls, { facesEye: 1, tolerance: LAYER_TOLERANCE + deviation, blur: LAYER_BLUR });
}

/** Discs within the silhouettes of layers, as they turn to the light. */
function discSolids({ figures }: PuffLayers): PuffSolids {
  const balls = figures.map(({ discs }) => discs);
  return solidsOf(balls, { facesEye: 2, tolerance: DISC_TOLERANCE, blur: 0 });
}

/** The visible front surfaces of baked layers, as patches of points. */

/** Texels along each side of a patch. */
const PATCH_TEXELS = 8;
/** Minimum cosine between normals of neighbouring texels; below it they span a crease or a rim. */
const SMOOTH_COSINE = 0.985;
/** Number of points between four texels, along x and along y, at a crease. */
const CREASE_POINTS = 3;

/** Front surfaces of all layers. */
export function frontsOf(layers: PuffLayers): Patch[][] {
  return Array.from({ length: layers.count }, (_, layer) => finished(findingFront(layers, layer)));
}

/** The front surface of a layer, in slices. Points are denser where filtering interpolates normals across a crease. */
function* findingFront(layers: PuffLayers, layer: number): Work<Patch[]> {
  const patches: Patch[] = [];
  for (let j = 0; j < layers.size - 1; j += PATCH_TEXELS) {
    for (let i = 0; i < layers.size - 1; i += PATCH_TEXELS) {
      const points = pointsIn(layers, layer, i, j);
      if (points.length > 0) patches.push(bounded(Float32Array.from(points)));
    }
    yield;
  }
  return patches;
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

/** Adds points on the puff between the texel centre (x, y) and its right, upper and diagonal neighbours. */
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
