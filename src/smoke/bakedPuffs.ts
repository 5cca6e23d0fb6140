import type { BakedPuffs } from '../device/puffTextures.ts';
import { FIRST_BORDER } from '../device/ramps.ts';
import { bakingLobes } from '../puffs/bake/bakeLobes.ts';
import { LruCache } from '../puffs/lru.ts';
import { LOBE_SHAPES } from '../puffs/lobeShapes.ts';
import type { PuffShape } from '../puffs/shapes.ts';
import { finished, type Work } from '../puffs/work.ts';
import { codeOf, here } from './extraPasses.ts';

/** Baked puffs by shape. Smokes with the same object share their textures on a device. */
const cache = new LruCache<BakedPuffs>(8);
/** Work in progress by shape. Concurrent requests for the same puffs share it. */
const begun = new Map<string, Work<BakedPuffs>>();

/** Parts of puffs that are otherwise baked synchronously on first access. */
export interface PuffParts {
  /** Start caps, which lobe puffs need unless they turn, stretch or unfold. */
  readonly caps?: boolean;
  /** Billboards, if their code is loaded. */
  readonly billboards?: boolean;
}

/** Bakes puffs like {@link bakingPuffs}, but synchronously. Defaults to the built-in shapes. */
export function bakedPuffs(shapes: readonly PuffShape[] = LOBE_SHAPES): BakedPuffs {
  return finished(bakingPuffs(shapes));
}

/**
 * Bakes lobe puffs in steps of about a millisecond, and then billboards in steps of a few milliseconds.
 * @param shapes one for each variation
 */
export function* bakingPuffs(shapes: readonly PuffShape[], parts: PuffParts = {}): Work<BakedPuffs> {
  const key = JSON.stringify(shapes.map(({ lobes }) => lobes));
  for (;;) {
    const puffs = cache.get(key) ?? workOn(key, () => bakingNew(shapes));
    if (puffs && parts.caps) yield* puffs.lobes.bakingCaps();
    if (puffs && parts.billboards) yield* here.billboards?.bakingBillboards(shapes) ?? [];
    if (puffs) return puffs;
    yield;
  }
}

/** Advances the work for a key by one step. Returns the puffs and caches them once they are complete. */
function workOn(key: string, begin: () => Work<BakedPuffs>): BakedPuffs | undefined {
  const work = begun.get(key) ?? begin();
  begun.delete(key);
  const { done, value } = work.next();
  if (done) cache.add(key, value);
  else begun.set(key, work);
  return done ? value : undefined;
}

/** The code of billboards must be loaded, see `fetchExtras`. */
function* bakingNew(shapes: readonly PuffShape[]): Work<BakedPuffs> {
  const lobes = yield* bakingLobes(shapes, FIRST_BORDER);
  let billboards: BakedPuffs['billboards'] | undefined;
  return {
    lobes,
    get billboards() {
      billboards ??= finished(codeOf('billboards').bakingBillboards(shapes));
      return billboards;
    },
  };
}
