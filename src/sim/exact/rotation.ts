/** Turns as unit quaternions x, y, z, w, with the same bits in every engine: see `sine.ts`. */
import { cos, sin } from './sine.ts';

type Vector = readonly [x: number, y: number, z: number];
export type Quaternion = readonly [x: number, y: number, z: number, w: number];

/** Angles about x, then y, then z, each about the world's axis (radians), as a quaternion. */
export function quaternionFromAngles(angles: Vector): Quaternion {
  const [i, j, k] = angles.map((angle) => sin(angle / 2));
  const [x, y, z] = angles.map((angle) => cos(angle / 2));
  return [i * y * z - x * j * k, x * j * z + i * y * k, x * y * k - i * j * z, x * y * z + i * j * k];
}

/** The vector after the turn. */
export function rotate(quaternion: Quaternion, vector: Vector): Vector {
  const once = cross(quaternion, vector);
  const twice = cross(quaternion, once);
  return vector.map((along, axis) => along + 2 * (quaternion[3] * once[axis] + twice[axis])) as unknown as Vector;
}

/** The cross product of two vectors, or of the vectors that quaternions begin with. */
export function cross(a: ArrayLike<number>, b: ArrayLike<number>): Vector {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}
