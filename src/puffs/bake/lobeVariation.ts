/** Bakes single variations of lobe puffs, memoized in an LRU cache. */
import { LruCache } from '../lru.ts';
import { deepestSeen, reachOf } from '../lobes.ts';
import { orientationOf, rotatedLobes } from '../orientation.ts';
import type { Lobe } from '../shapes.ts';
import type { Work } from '../../work.ts';

/** All lengths in particle radii. */
export interface LobeVariation {
  readonly lobes: readonly Lobe[];
  /** Radius of the bounding sphere of all lobes about the particle's centre. */
  readonly reach: number;
  /** Depth of the deepest visible point behind the centre plane, over the sampled orientations. */
  readonly depth: number;
}

/** Number of orientations in which the depth is measured. */
const SIDES = 16;
/** Resetting a knob or adding a variation does not bake the same variation twice. */
const variations = new LruCache<LobeVariation>(96);
/** Bakes a variation in slices, or returns it from the cache. */
export function* bakingVariation(lobes: readonly Lobe[]): Work<LobeVariation> {
  const key = JSON.stringify(lobes);
  const variation = variations.get(key) ?? (yield* measuring(lobes));
  variations.add(key, variation);
  return variation;
}

function* measuring(lobes: readonly Lobe[]): Work<LobeVariation> {
  let depth = 0;
  for (let side = 0; side < SIDES; side++) {
    const seen = rotatedLobes(orientationOf((side * 256) / SIDES, 2.4 * side), lobes);
    depth = Math.max(depth, deepestSeen(seen));
    yield;
  }
  return { lobes, reach: reachOf(lobes), depth };
}
