/** Bakes single variations of lobe puffs, memoized in an LRU cache. */
import { LruCache } from '../lru.ts';
import { deepestSeen, reachOf } from '../lobes.ts';
import { orientationOf, rotatedLobes } from '../orientation.ts';
import { surfaceOf } from './patches.ts';
import type { Lobe } from '../shapes.ts';
import { bakingTable, latestCap } from './startCaps.ts';
import type { Work } from '../work.ts';

/** All lengths in particle radii. */
export interface LobeVariation {
  readonly lobes: readonly Lobe[];
  /** Start cap table, see src/puffs/bake/startCaps.ts. */
  readonly startCaps: Float32Array;
  /** See {@link latestCap}. */
  readonly latestCap: number;
  /** Radius of the bounding sphere of all lobes about the particle's centre. */
  readonly reach: number;
  /** Depth of the deepest visible point behind the centre plane, over the sampled orientations. */
  readonly depth: number;
}

/** Number of orientations in which the depth is measured. */
const SIDES = 16;
/** Each entry takes about 8 kB. */
const cache = new LruCache<LobeVariation>(96);

/**
 * Bakes a variation in slices, or returns it from the cache. Resetting a knob or adding a variation does not bake the
 * same variation twice.
 */
export function* bakingVariation(lobes: readonly Lobe[], litThreshold: number): Work<LobeVariation> {
  const key = JSON.stringify([litThreshold, lobes]);
  const variation = cache.get(key) ?? (yield* baking(lobes, litThreshold));
  cache.add(key, variation);
  return variation;
}

function* baking(lobes: readonly Lobe[], litThreshold: number): Work<LobeVariation> {
  let depth = 0;
  for (let side = 0; side < SIDES; side++) {
    const seen = rotatedLobes(orientationOf((side * 256) / SIDES, 2.4 * side), lobes);
    depth = Math.max(depth, deepestSeen(seen));
    yield;
  }
  const surface = surfaceOf(lobes);
  yield;
  const startCaps = yield* bakingTable(surface, litThreshold);
  return { lobes, startCaps, latestCap: latestCap(surface), reach: reachOf(lobes), depth };
}
