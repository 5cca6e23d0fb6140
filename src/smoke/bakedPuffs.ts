import type { BakedPuffs } from '../device/puffTextures.ts';
import { FIRST_BORDER } from '../device/ramps.ts';
import { bakingLobes } from '../puffs/bake/bakeLobes.ts';
import { LruCache } from '../puffs/lru.ts';
import { LOBE_SHAPES } from '../puffs/lobeShapes.ts';
import type { PuffShape } from '../puffs/shapes.ts';
import { finished, type Work } from '../puffs/work.ts';
import { codeOf, here } from './extraPasses.ts';

/** Smokes whose puffs are the same object share their textures on a device. */
const cache = new LruCache<BakedPuffs>(8);
/** Puffs that somebody bakes; who wants the same goes on with them. */
const begun = new Map<string, Work<BakedPuffs>>();

/** Puffs as {@link bakingPuffs} makes them, at once; the default ones where no shapes are given. */
export function bakedPuffs(shapes: readonly PuffShape[] = LOBE_SHAPES): BakedPuffs {
  return finished(bakingPuffs(shapes));
}

/**
 * Bakes puffs of lobes in pieces of about a millisecond, and then billboards in pieces of some milliseconds.
 * @param shapes a variation each
 * @param withBillboards false bakes billboards when they are first asked for, at once; so does code that is not here yet
 */
export function* bakingPuffs(shapes: readonly PuffShape[], withBillboards = false): Work<BakedPuffs> {
  const key = JSON.stringify(shapes.map(({ lobes }) => lobes));
  for (;;) {
    const puffs = cache.get(key) ?? workOn(key, () => bakingNew(shapes));
    if (puffs && withBillboards) yield* here.billboards?.bakingBillboards(shapes) ?? [];
    if (puffs) return puffs;
    yield;
  }
}

/** A piece of the work on some puffs, which are kept and given when they are ready. */
function workOn(key: string, begin: () => Work<BakedPuffs>): BakedPuffs | undefined {
  const work = begun.get(key) ?? begin();
  begun.delete(key);
  const { done, value } = work.next();
  if (done) cache.add(key, value);
  else begun.set(key, work);
  return done ? value : undefined;
}

/** Billboards need code that `fetchExtras` has brought. */
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
