/** Rotations as unit quaternions x, y, z, w, with bit-identical results in every engine, see `sine.ts`. */
import { cos, sin } from './sine.ts';

type Vector = readonly [x: number, y: number, z: number];
export type Quaternion = readonly [x: number, y: number, z: number, w: number];

/** The quaternion of rotations about the world axes x, then y, then z, in radians. */
export function quaternionFromAngles(angles: Vector): Quaternion {
  const [i, j, k] = angles.map((angle) => sin(angle / 2));
  const [x, y, z] = angles.map((angle) => cos(angle / 2));
  return [i * y * z - x * j * k, x * j * z + i * y * k, x * y * k - i * j * z, x * y * z + i * j * k];
}

/** Rotates a vector. */
export function rotate(quaternion: Quaternion, vector: Vector): Vector {
  const once = cross(quaternion, vector);
  const twice = cross(quaternion, once);
  return vector.map((along, axis) => along + 2 * (quaternion[3] * once[axis] + twice[axis])) as unknown as Vector;
}

/** The cross product of two vectors, or of the vector parts of two quaternions. */
export function cross(a: ArrayLike<number>, b: ArrayLike<number>): Vector {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}
