/**
 * Orientation of a lobe puff in world space: a rotation by its roll about an axis that its seed selects. CPU version of
 * shaders/lib/orientation.glsl, for baking and tests.
 */
import { spherePoint, type Vector } from './vector.ts';
import type { Lobe } from './shapes.ts';
import { SEEDS } from '../../base/constants.ts';

/** Rotation matrix from the puff's local space to world space, as three columns. */
export type Rotation = readonly [Vector, Vector, Vector];

/**
 * @param seed random number of the particle, 0..255
 * @param roll in radians
 */
export function orientationOf(seed: number, roll: number): Rotation {
  const [x, y, z] = spherePoint(seed, SEEDS);
  const [c, s] = [Math.cos(roll), Math.sin(roll)];
  const t = 1 - c;
  return [
    [t * x * x + c, t * x * y + s * z, t * x * z - s * y],
    [t * x * y - s * z, t * y * y + c, t * y * z + s * x],
    [t * x * z + s * y, t * y * z - s * x, t * z * z + c],
  ];
}

export function rotated([a, b, c]: Rotation, [x, y, z]: Vector): Vector {
  return [a[0] * x + b[0] * y + c[0] * z, a[1] * x + b[1] * y + c[1] * z, a[2] * x + b[2] * y + c[2] * z];
}

export function rotatedLobes(rotation: Rotation, lobes: readonly Lobe[]): Lobe[] {
  return lobes.map(({ center, radius }) => ({ center: rotated(rotation, center), radius }));
}
