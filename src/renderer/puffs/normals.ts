/** What shapes the shading normals of a puff: the lobe normals, smoothed along creases and blended with the puff's overall normal. */
import type { Lobe } from './shapes.ts';
import type { Vector } from './vector.ts';

/**
 * Weight of the puff's overall normal in every normal, 0..1. At 0 each lobe is shaded as a separate ball; at 1 the
 * lobes are no longer visible in the shading.
 */
export const NORMAL_BLEND = 0.38;

/**
 * Width of the fillet along creases, in particle radii. Normals (not positions) change gradually from one lobe to the
 * next there, so that the terminator curves around a lobe instead of ending in a sharp corner at a crease.
 */
export const CREASE_FILLET = 0.13;

/** Centroid of the lobes by volume, with overlaps counted twice. The overall normal points away from it. */
export function middleOf(lobes: readonly Lobe[]): Vector {
  let [x, y, z, total] = [0, 0, 0, 0];
  for (const { center, radius } of lobes) {
    const volume = radius ** 3;
    x += center[0] * volume;
    y += center[1] * volume;
    z += center[2] * volume;
    total += volume;
  }
  return [x / total, y / total, z / total];
}
