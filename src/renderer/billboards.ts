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
import { findingFront } from './puffs/billboards/fronts.ts';
import { LruCache } from './puffs/lru.ts';
import { bakingLayers } from './puffs/billboards/layers.ts';
import { reachOf } from './puffs/lobes.ts';
import { billboardShapes, type PuffShape } from './puffs/shapes.ts';
import { solidsOf } from './puffs/bake/solids.ts';
import { bakingTable, joined, latestCap } from './puffs/bake/startCaps.ts';
import type { Work } from '../base/work.ts';

/** The shaders of billboard bodies. */
export const billboardShaders: Shaders = { vertexShader, fragmentShader };

/** Tolerance of the outline and the relief: in radii for facets, texels and filtering, in pixels for mipmap levels. */
const LAYER_TOLERANCE = 0.06;
const LAYER_BLUR = 3;

const cache = new LruCache<BillboardPuffs>(4);

/**
 * Bakes billboards in steps of a few milliseconds, or returns them from the LRU cache.
 * @param shapes viewed from +z
 */
export function bakingBillboards(shapes: readonly PuffShape[]): Work<BillboardPuffs> {
  const key = JSON.stringify(shapes.map(({ lobes }) => lobes));
  return cache.making(key, () => baking(billboardShapes(shapes)));
}

function* baking(shapes: readonly PuffShape[]): Work<BillboardPuffs> {
  const layers = yield* bakingLayers(shapes);
  const tables: Float32Array[] = [];
  let latest = 0;
  for (let layer = 0; layer < layers.count; layer++) {
    const front = yield* findingFront(layers, layer);
    tables.push(yield* bakingTable(front, FIRST_BORDER));
    latest = Math.max(latest, latestCap(front));
  }
  const data = {
    layers,
    startCaps: joined(tables),
    latestCap: latest,
    casters: castersOf(shapes),
    solids: solidsOf(
      shapes.map(({ lobes }) => lobes),
      { facesEye: true, tolerance: LAYER_TOLERANCE, blur: LAYER_BLUR },
    ),
    reach: Math.max(...shapes.map(({ lobes }) => reachOf(lobes))),
    depth: Math.max(...layers.figures.map(({ depth }) => depth)),
  };
  return { ...data, texturesFor: (context) => new BillboardTextures(context, data) };
}
