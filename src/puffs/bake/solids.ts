/**
 * What of a puff is certainly opaque, and all that it could show: balls that the drawn puff differs from by no more than
 * a tolerance. The simulator leaves out what others hide by them. Of lobes these are the lobes themselves.
 */
import { MAX_LOBES } from '../lobes.ts';
import type { Lobe } from '../shapes.ts';

/** All lengths in particle radii. */
export interface PuffSolids {
  /** For each variation the x of its balls, their y, z and radii; a ball of radius 0 is absent. */
  readonly table: Float32Array;
  /** Balls of each variation: 4, 8 or 12. */
  readonly balls: number;
  /** Whether the puff turns to the eye and rolls about the view axis; else it stands in the world. */
  readonly facesEye: boolean;
  /** How far outline and height of what is drawn may be from the balls': in radii, and in pixels of the target. */
  readonly tolerance: number;
  readonly blur: number;
}

/** The simulator handles so many balls at a time. */
const BLOCK = 4;

/** @param variations at least one, each of at most {@link MAX_LOBES} lobes */
export function solidsOf(
  variations: readonly (readonly Lobe[])[],
  drawn: Omit<PuffSolids, 'table' | 'balls'>,
): PuffSolids {
  const max = Math.max(...variations.map((lobes) => lobes.length));
  if (max > MAX_LOBES) throw new RangeError(`A puff has ${max} lobes; it takes at most ${MAX_LOBES}.`);
  const balls = BLOCK * Math.ceil(max / BLOCK);
  const table = new Float32Array(4 * balls * variations.length);
  variations.forEach((lobes, variation) =>
    lobes.forEach(({ center, radius }, ball) =>
      [...center, radius].forEach((value, column) => (table[(4 * variation + column) * balls + ball] = value)),
    ),
  );
  return { ...drawn, table, balls };
}
