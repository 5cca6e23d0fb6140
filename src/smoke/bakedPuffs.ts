import { bakePuffs } from '../puffs/layers.ts';
import { PUFF_SHAPES } from '../puffs/shapes.ts';
import { bakeStartCaps } from '../puffs/startCaps.ts';
import type { BakedPuffs } from '../device/puffTextures.ts';
import { FIRST_BORDER } from '../device/ramps.ts';

let baked: BakedPuffs | undefined;

/** The default puffs, baked once for all devices of the page: they are the same bytes everywhere. */
export function bakedPuffs(): BakedPuffs {
  if (!baked) {
    const layers = bakePuffs(PUFF_SHAPES);
    baked = { layers, startCaps: bakeStartCaps(layers, FIRST_BORDER) };
  }
  return baked;
}
