import type { BakedPuffs } from '../device/puffTextures.ts';
import { FIRST_BORDER } from '../device/ramps.ts';
import { bakingLobes } from '../puffs/bakeLobes.ts';
import { Kept } from '../puffs/kept.ts';
import { bakePuffs } from '../puffs/layers.ts';
import { LOBE_SHAPES } from '../puffs/lobeShapes.ts';
import { frontsOf } from '../puffs/patches.ts';
import { PUFF_SHAPES, type PuffShape } from '../puffs/shapes.ts';
import { bakeStartCaps } from '../puffs/startCaps.ts';
import { finished, type Work } from '../puffs/work.ts';

/** Smokes whose puffs are the same object share their textures on a device. */
const kept = new Kept<BakedPuffs>(8);
let billboards: BakedPuffs['billboards'] | undefined;

/** Puffs as {@link bakingPuffs} makes them, at once; the default ones where no shapes are given. */
export function bakedPuffs(shapes: readonly PuffShape[] = LOBE_SHAPES): BakedPuffs {
  return finished(bakingPuffs(shapes));
}

/**
 * Bakes puffs of lobes, in pieces of about a millisecond. As billboards they are those that were drawn by hand.
 * @param shapes a variation each
 * @throws RangeError when a shape has too many lobes
 */
export function* bakingPuffs(shapes: readonly PuffShape[]): Work<BakedPuffs> {
  const key = JSON.stringify(shapes.map(({ lobes }) => lobes));
  const puffs = kept.get(key) ?? withBillboards(yield* bakingLobes(shapes, FIRST_BORDER));
  kept.add(key, puffs);
  return puffs;
}

/** Billboards are baked when they are first asked for. */
function withBillboards(lobes: BakedPuffs['lobes']): BakedPuffs {
  return {
    lobes,
    get billboards() {
      billboards ??= billboardsOf(PUFF_SHAPES);
      return billboards;
    },
  };
}

function billboardsOf(shapes: readonly PuffShape[]): BakedPuffs['billboards'] {
  const layers = bakePuffs(shapes);
  return { layers, startCaps: bakeStartCaps(frontsOf(layers), FIRST_BORDER) };
}
