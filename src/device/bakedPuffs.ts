import { bakePuffs, type PuffLayers } from '../puffs/layers.ts';
import { PUFF_SHAPES } from '../puffs/shapes.ts';
import { bakeStartCaps, type StartCaps } from '../puffs/startCaps.ts';
import { FIRST_BORDER } from './ramps.ts';

let baked: { layers: PuffLayers; startCaps: StartCaps } | undefined;

/** The default puffs, baked once for all devices of the page: they are the same bytes everywhere. */
export function bakedPuffs(): { layers: PuffLayers; startCaps: StartCaps } {
  if (!baked) {
    const layers = bakePuffs(PUFF_SHAPES);
    baked = { layers, startCaps: bakeStartCaps(layers, FIRST_BORDER) };
  }
  return baked;
}
