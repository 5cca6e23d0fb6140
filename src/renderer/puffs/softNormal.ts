/** Shading normals on the CPU, which the lobes that shaders intersect do not need. */
import { CREASE_FILLET, NORMAL_BLEND } from './normals.ts';
import type { Lobe } from './shapes.ts';
import { minus, mixed, normalized, type Vector } from './vector.ts';

/**
 * Unit shading normal of a puff at `p` on the surface of one of its lobes.
 * @param middle of all lobes, see `middleOf` in normals.ts
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
