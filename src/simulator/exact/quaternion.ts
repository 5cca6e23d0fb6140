/**
 * Less common operations on unit quaternions x, y, z, w, with bit-identical results in every engine, see `sine.ts`.
 */
import { acos, asin, atan2 } from './arc.ts';
import { hypot, sin } from './sine.ts';
import type { Quaternion } from './rotation.ts';

/** Quaternions with a larger cosine between them are interpolated linearly. */
const CLOSE = 0.9995;
/** Above this sine of the angle z, the rotations about x and y share an axis (gimbal lock). */
const UPRIGHT = 0.9999999;

/** The product a * b: the rotation `b` followed by the rotation `a`. */
export function multiply([x, y, z, w]: Quaternion, [i, j, k, l]: Quaternion): Quaternion {
  return [
    w * i + x * l + y * k - z * j,
    w * j + y * l + z * i - x * k,
    w * k + z * l + x * j - y * i,
    w * l - x * i - y * j - z * k,
  ];
}

/** Spherical linear interpolation along the shorter arc. @param share 0 is `from`, 1 is `to` */
export function slerp(from: Quaternion, to: Quaternion, share: number): Quaternion {
  const product = from.reduce((sum, part, index) => sum + part * to[index], 0);
  const cosine = Math.abs(product);
  const angle = acos(Math.min(cosine, 1));
  const weightOf = (part: number) => (cosine < CLOSE ? sin(part * angle) / sin(angle) : part);
  const [a, b] = [weightOf(1 - share), product < 0 ? -weightOf(share) : weightOf(share)];
  const [x, y, z, w] = from.map((part, index) => a * part + b * to[index]);
  const length = hypot(x, y, z, w);
  return [x / length, y / length, z / length, w / length];
}

/**
 * Euler angles in radians of a rotation about x, then z, then y. z is between -pi / 2 and pi / 2; at both limits x is
 * 0.
 */
export function anglesYZX([x, y, z, w]: Quaternion): [x: number, y: number, z: number] {
  const rise = Math.min(Math.max(2 * (x * y + z * w), -1), 1);
  if (Math.abs(rise) > UPRIGHT) return [0, atan2(2 * (x * z + y * w), 1 - 2 * (x * x + y * y)), asin(rise)];
  return [
    atan2(2 * (x * w - y * z), 1 - 2 * (x * x + z * z)),
    atan2(2 * (y * w - x * z), 1 - 2 * (y * y + z * z)),
    asin(rise),
  ];
}
