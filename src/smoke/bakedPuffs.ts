import type { BakedPuffs } from '../device/puffTextures.ts';
import { FIRST_BORDER } from '../device/ramps.ts';
import { bakingLobes } from '../puffs/bakeLobes.ts';
import { Kept } from '../puffs/kept.ts';
import { castersOf } from '../puffs/casters.ts';
import { bakePuffs } from '../puffs/layers.ts';
import { LOBE_SHAPES } from '../puffs/lobeShapes.ts';
import { frontsOf } from '../puffs/patches.ts';
import { PUFF_SHAPES, type PuffShape } from '../puffs/shapes.ts';
import { solidsOf } from '../puffs/solids.ts';
import { bakeStartCaps, latestCap } from '../puffs/startCaps.ts';
import { finished, type Work } from '../puffs/work.ts';

/** Radii by which facets, texels and their filter move outline and relief, and pixels by which smaller levels do. */
const LAYER_TOLERANCE = 0.06;
const LAYER_BLUR = 3;

/** Smokes whose puffs are the same object share their textures on a device. */
const kept = new Kept<BakedPuffs>(8);
/** Puffs that somebody bakes; who wants the same goes on with them. */
const begun = new Map<string, Work<BakedPuffs>>();
const keptBillboards = new Kept<BakedPuffs['billboards']>(4);

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
export function* bakingPuffs(shapes: readonly PuffShape[], fronts = PUFF_SHAPES): Work<BakedPuffs> {
  const key = keyOf(shapes) + keyOf(fronts);
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

function* bakingNew(shapes: readonly PuffShape[], fronts: readonly PuffShape[]): Work<BakedPuffs> {
  return withFronts(yield* bakingLobes(shapes, FIRST_BORDER), fronts);
}

/** Billboards are baked when they are first asked for. */
function withFronts(lobes: BakedPuffs['lobes'], fronts: readonly PuffShape[]): BakedPuffs {
  let billboards: BakedPuffs['billboards'] | undefined;
  return {
    lobes,
    get billboards() {
      billboards ??= billboardsOf(fronts);
      return billboards;
    },
  };
}

function billboardsOf(fronts: readonly PuffShape[]): BakedPuffs['billboards'] {
  const found = keptBillboards.get(keyOf(fronts));
  if (found) return found;
  const layers = bakePuffs(fronts);
  const surfaces = frontsOf(layers);
  const startCaps = bakeStartCaps(surfaces, FIRST_BORDER);
  const solids = solidsOf(
    fronts.map(({ lobes }) => lobes),
    { facesEye: true, tolerance: LAYER_TOLERANCE, blur: LAYER_BLUR },
  );
  const billboards = {
    layers,
    startCaps,
    latestCap: latestCap(surfaces.flat()),
    casters: castersOf(fronts),
    solids,
  };
  keptBillboards.add(keyOf(fronts), billboards);
  return billboards;
}

function keyOf(shapes: readonly PuffShape[]): string {
  return JSON.stringify(shapes.map(({ lobes }) => lobes));
}
