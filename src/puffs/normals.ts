/** The direction in which a puff's surface is lit: that of its lobes, softened along creases and towards the whole. */
import type { Lobe } from './shapes.ts';
import { minus, mixed, normalized, type Vector } from './vector.ts';

/**
 * Share of the puff's overall normal in every normal (0..1). At 0 each lobe is lit as a ball of its own and
 * a cluster looks like a bag of marbles; at 1 the lobes vanish in the big form.
 */
export const NORMAL_BLEND = 0.38;

/**
 * Reach of the fillet along the creases in particle radii: normals (not positions) turn gradually from one lobe to the
 * next there, so that the border of the light runs round a lobe instead of stopping at a crease with a sharp corner.
 */
export const CREASE_FILLET = 0.13;

/** Centre of the lobes' volumes, overlaps counted twice: where the overall normal points away from. */
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
 * Unit normal of a puff at `p` on the surface of one of its lobes.
 * @param middle of all lobes, see {@link middleOf}
 * @param blend share of the overall normal, 0..1
 */
export function softNormal(lobes: readonly Lobe[], middle: Vector, p: Vector, blend = NORMAL_BLEND): Vector {
  return normalized(mixed(filletedNormal(lobes, p), normalized(minus(p, middle)), blend));
}

/** Direction of the surface at `p`, with those of the other lobes near it mixed in. */
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
