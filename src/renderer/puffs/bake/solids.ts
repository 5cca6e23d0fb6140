/**
 * Balls that bound a puff from inside and outside: the drawn puff differs from them by at most a tolerance. The
 * simulator uses them for occlusion culling. The balls of a lobe puff are its lobes.
 */
import { MAX_LOBES } from '../../../base/constants.ts';
import type { Lobe } from '../shapes.ts';

/** All lengths in particle radii. */
export interface PuffSolids {
  /** Per variation: the x of all its balls, then their y, z and radii. Unused balls have radius 0. */
  readonly table: Float32Array;
  /** Balls per variation: 4, 8 or 12. */
  readonly balls: number;
  /**
   * 1 if the puff faces the eye and rolls about the view axis, 2 if the balls, with their centres on the centre plane, are discs that
   * such a puff turns to the light; 0 if it is oriented in world space.
   */
  readonly facesEye: 0 | 1 | 2;
  /** Maximum deviation of the drawn outline and height from the balls: `tolerance` in radii, `blur` in pixels. */
  readonly tolerance: number;
  readonly blur: number;
}

/** Balls per SIMD block of the simulator. */
const BLOCK = 4;

/**
 * @param variations at least one, each with at most {@link MAX_LOBES} lobes
 * @throws RangeError if a variation has more lobes
 */
export function solidsOf(
  variations: readonly (readonly Lobe[])[],
  drawn: Omit<PuffSolids, 'table' | 'balls'>,
): PuffSolids {
  const max = Math.max(...variations.map((lobes) => lobes.length));
  if (max > MAX_LOBES) throw new RangeError(`A puff has ${max} lobes. The limit is ${MAX_LOBES}.`);
  const balls = BLOCK * Math.ceil(max / BLOCK);
  const table = new Float32Array(4 * balls * variations.length);
  variations.forEach((lobes, variation) =>
    lobes.forEach(({ center, radius }, ball) =>
      [...center, radius].forEach((value, column) => (table[(4 * variation + column) * balls + ball] = value)),
    ),
  );
  return { ...drawn, table, balls };
}
