import type { BakedPuffs } from '../device/puffTextures.ts';
import { FIRST_BORDER } from '../device/ramps.ts';
import { bakingLobes } from '../puffs/bakeLobes.ts';
import { Kept } from '../puffs/kept.ts';
import { LOBE_SHAPES } from '../puffs/lobeShapes.ts';
import type { PuffShape } from '../puffs/shapes.ts';
import { finished, type Work } from '../puffs/work.ts';
import { codeOf } from './extraPasses.ts';

/** Smokes whose puffs are the same object share their textures on a device. */
const kept = new Kept<BakedPuffs>(8);
/** Puffs that somebody bakes; who wants the same goes on with them. */
const begun = new Map<string, Work<BakedPuffs>>();

/** Puffs as {@link bakingPuffs} makes them, at once; the default ones where no shapes are given. */
export function bakedPuffs(shapes: readonly PuffShape[] = LOBE_SHAPES, fronts?: readonly PuffShape[]): BakedPuffs {
  return finished(bakingPuffs(shapes, fronts));
}

/**
 * Bakes puffs of lobes, in pieces of about a millisecond.
 * @param shapes a variation each
 * @param fronts what they are as billboards, from +z; those that were drawn by hand where absent
 * @throws RangeError when a shape has too many lobes
 */
export function* bakingPuffs(shapes: readonly PuffShape[], fronts?: readonly PuffShape[]): Work<BakedPuffs> {
  const key = keyOf(shapes) + keyOf(fronts ?? []);
  for (;;) {
    const puffs = kept.get(key) ?? workOn(key, () => bakingNew(shapes, fronts));
    if (puffs) return puffs;
    yield;
  }
}

/** A piece of the work on some puffs, which are kept and given when they are ready. */
function workOn(key: string, begin: () => Work<BakedPuffs>): BakedPuffs | undefined {
  const work = begun.get(key) ?? begin();
  begun.delete(key);
  const { done, value } = work.next();
  if (done) kept.add(key, value);
  else begun.set(key, work);
  return done ? value : undefined;
}

function* bakingNew(shapes: readonly PuffShape[], fronts?: readonly PuffShape[]): Work<BakedPuffs> {
  return withFronts(yield* bakingLobes(shapes, FIRST_BORDER), fronts);
}

/** Billboards are baked when they are first asked for, by code that `fetchExtras` has brought. */
function withFronts(lobes: BakedPuffs['lobes'], fronts?: readonly PuffShape[]): BakedPuffs {
  let billboards: BakedPuffs['billboards'] | undefined;
  return {
    lobes,
    get billboards() {
      billboards ??= codeOf('billboards').bakeBillboards(fronts);
      return billboards;
    },
  };
}

function keyOf(shapes: readonly PuffShape[]): string {
  return JSON.stringify(shapes.map(({ lobes }) => lobes));
}
