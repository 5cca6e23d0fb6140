/** One variation of the puffs of lobes, baked: kept for as long as others have not taken its room. */
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
  /** A table as src/puffs/bake/startCaps.ts describes it. */
  readonly startCaps: Float32Array;
  /** See {@link latestCap}. */
  readonly latestCap: number;
  /** Radius of the sphere about the particle's centre that holds all lobes. */
  readonly reach: number;
  /** How deep behind the centre plane something of it can be seen, from whatever side. */
  readonly depth: number;
}

/** Sides from which a puff is measured. */
const SIDES = 16;
/** One takes about 8 kB. */
const cache = new LruCache<LobeVariation>(96);

/**
 * Bakes a variation in pieces, or takes it from those that are kept: turning a knob back, or adding a variation, bakes
 * nothing twice.
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
