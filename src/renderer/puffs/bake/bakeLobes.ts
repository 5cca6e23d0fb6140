/** Bakes lobe puffs to the tables that bodies and volumes use. */
import { deepestSeen, reachOf } from '../lobes.ts';
import { LruCache } from '../lru.ts';
import { CREASE_FILLET, middleOf, NORMAL_BLEND } from '../normals.ts';
import { orientationOf, rotatedLobes } from '../orientation.ts';
import type { Lobe, PuffShape } from '../shapes.ts';
import { solidsOf, type PuffSolids } from './solids.ts';
import { finished, type Work } from '../../../base/work.ts';

/** All lengths in particle radii. */
export interface LobePuffs {
  /** Maximum number of lobes per variation. */
  readonly lobeCount: number;
  /** Number of variations. */
  readonly count: number;
  /** Per variation: `lobeCount` lobes of four floats, centre and radius, then their centroid and a zero. */
  readonly table: Float32Array;
  readonly solids: PuffSolids;
  /** Radius of the bounding sphere of all puffs about the particle's centre. */
  readonly reach: number;
  /** Upper bound on the depth of visible points behind the centre plane, over all view directions. */
  readonly depth: number;
  /** Weight of the overall normal, see {@link NORMAL_BLEND}. */
  readonly blend: number;
  /** See {@link CREASE_FILLET}. */
  readonly fillet: number;
}

/** Position tolerance of rotated lobes: GPU sines have an error of about 2^-11. */
const ROTATION_TOLERANCE = 0.002;
/** Margin for visible points between the depth samples, and the step the bound is rounded up to, in radii. */
const DEPTH_SLACK = 0.05;
const DEPTH_STEP = 0.1;
/** Number of orientations in which the depth is measured. */
const SIDES = 16;
/** Depths by lobes: resetting a knob or adding a variation does not measure the same variation twice. */
const depths = new LruCache<number>(96);

/** @param shapes at least one, each with at most 12 lobes */
export function bakeLobes(shapes: readonly PuffShape[]): LobePuffs {
  return finished(bakingLobes(shapes));
}

/** As {@link bakeLobes}, in slices of about a millisecond. */
export function* bakingLobes(shapes: readonly PuffShape[]): Work<LobePuffs> {
  const ofAll = shapes.map(({ lobes }) => lobes);
  const lobeCount = Math.max(...ofAll.map(({ length }) => length));
  let deepest = 0;
  for (const lobes of ofAll)
    deepest = Math.max(deepest, yield* depths.making(JSON.stringify(lobes), () => measuringDepth(lobes)));
  return {
    lobeCount,
    count: shapes.length,
    table: Float32Array.from(ofAll.flatMap((lobes) => rowOf(lobes, lobeCount))),
    reach: Math.max(...ofAll.map(reachOf)),
    depth: Math.ceil((deepest + DEPTH_SLACK) / DEPTH_STEP) * DEPTH_STEP,
    solids: solidsOf(ofAll, { facesEye: 0, tolerance: ROTATION_TOLERANCE, blur: 0 }),
    blend: NORMAL_BLEND,
    fillet: CREASE_FILLET,
  };
}

/** Depth of the deepest visible point behind the centre plane, over the sampled orientations, in particle radii. */
function* measuringDepth(lobes: readonly Lobe[]): Work<number> {
  let depth = 0;
  for (let side = 0; side < SIDES; side++) {
    const seen = rotatedLobes(orientationOf((side * 256) / SIDES, 2.4 * side), lobes);
    depth = Math.max(depth, deepestSeen(seen));
    yield;
  }
  return depth;
}

/** A shape's row of the table. Missing lobes are points inside the first one, so that they have no effect. */
function rowOf(lobes: readonly Lobe[], lobeCount: number): number[] {
  const absent = Array.from({ length: lobeCount - lobes.length }, () => ({ center: lobes[0].center, radius: 0 }));
  return [...[...lobes, ...absent].flatMap(({ center, radius }) => [...center, radius]), ...middleOf(lobes), 0];
}
