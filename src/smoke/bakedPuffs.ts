import { bakeLobes } from '../puffs/bakeLobes.ts';
import { bakePuffs } from '../puffs/layers.ts';
import { LOBE_SHAPES } from '../puffs/lobeShapes.ts';
import { frontsOf } from '../puffs/patches.ts';
import { PUFF_SHAPES } from '../puffs/shapes.ts';
import { bakeStartCaps } from '../puffs/startCaps.ts';
import type { BakedPuffs } from '../device/puffTextures.ts';
import { FIRST_BORDER } from '../device/ramps.ts';

let lobes: BakedPuffs['lobes'] | undefined;
let billboards: BakedPuffs['billboards'] | undefined;

const baked: BakedPuffs = {
  get lobes() {
    lobes ??= bakeLobes(LOBE_SHAPES, FIRST_BORDER);
    return lobes;
  },
  get billboards() {
    billboards ??= bakeBillboards();
    return billboards;
  },
};

/** The default puffs, each form baked once for all devices of the page: they are the same bytes everywhere. */
export function bakedPuffs(): BakedPuffs {
  return baked;
}

function bakeBillboards(): BakedPuffs['billboards'] {
  const layers = bakePuffs(PUFF_SHAPES);
  return { layers, startCaps: bakeStartCaps(frontsOf(layers), FIRST_BORDER) };
}
