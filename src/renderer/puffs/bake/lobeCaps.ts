/**
 * Bakes the start caps of lobe puffs. Puffs that turn, stretch or unfold do not need them, so this module is loaded on
 * demand.
 */
import { LruCache } from '../lru.ts';
import type { Lobe, PuffShape } from '../shapes.ts';
import type { Work } from '../../../base/work.ts';
import { surfaceOf } from './patches.ts';
import { bakingTable, joined, latestCap, type StartCaps } from './startCaps.ts';

export interface LobeCaps {
  readonly startCaps: StartCaps;
  /** See {@link latestCap}. */
  readonly latestCap: number;
}

interface VariationCaps {
  readonly table: Float32Array;
  readonly latest: number;
}

/** Variations by their lobes and threshold. Each takes about 8 kB. */
const cache = new LruCache<VariationCaps>(96);

/**
 * Bakes the start caps of all variations, in slices of about a millisecond.
 * @param litThreshold N . L from which a pixel's lit colour differs from its unlit one, -1..1
 */
export function* bakingCaps(shapes: readonly PuffShape[], litThreshold: number): Work<LobeCaps> {
  const variations: VariationCaps[] = [];
  for (const { lobes } of shapes) {
    const key = JSON.stringify([litThreshold, lobes]);
    variations.push(yield* cache.making(key, () => baking(lobes, litThreshold)));
  }
  return {
    startCaps: joined(variations.map(({ table }) => table)),
    latestCap: Math.max(...variations.map(({ latest }) => latest)),
  };
}

function* baking(lobes: readonly Lobe[], litThreshold: number): Work<VariationCaps> {
  const surface = surfaceOf(lobes);
  yield;
  return { table: yield* bakingTable(surface, litThreshold), latest: latestCap(surface) };
}
