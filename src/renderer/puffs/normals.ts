/** Shading normals of a puff: the lobe normals, smoothed along creases and blended with the puff's overall normal. */
import type { Lobe } from './shapes.ts';
import { minus, mixed, normalized, type Vector } from './vector.ts';

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

/**
 * Unit shading normal of a puff at `p` on the surface of one of its lobes.
 * @param middle of all lobes, see {@link middleOf}
 * @param blend weight of the overall normal, 0..1
 */
export function softNormal(lobes: readonly Lobe[], middle: Vector, p: Vector, blend = NORMAL_BLEND): Vector {
  return normalized(mixed(filletedNormal(lobes, p), normalized(minus(p, middle)), blend));
}

/** Lobe normal at `p`, blended with the normals of other lobes within the fillet. */
function filletedNormal(lobes: readonly Lobe[], p: Vector): Vector {
  let x = 0;
  let y = 0;
  let z = 0;
  for (let index = 0; index < lobes.length; index++) {
    const { center, radius } = lobes[index];
    const dx = p[0] - center[0];
    const dy = p[1] - center[1];
    const dz = p[2] - center[2];
    const distance = Math.sqrt(dx * dx + dy * dy + dz * dz);
    const nearness = 1 - Math.abs(distance - radius) / CREASE_FILLET;
    if (nearness <= 0) continue;
    const weight = (nearness * nearness) / (distance || 1);
    x += dx * weight;
    y += dy * weight;
    z += dz * weight;
  }
  return normalized([x, y, z]);
}
