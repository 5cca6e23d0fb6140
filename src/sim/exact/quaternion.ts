/** What few scenes do with unit quaternions x, y, z, w, with the same bits in every engine: see `sine.ts`. */
import { acos, asin, atan2 } from './arc.ts';
import { hypot, sin } from './sine.ts';
import type { Quaternion } from './rotation.ts';

/** From this cosine between them on, quaternions are blended along the straight line. */
const CLOSE = 0.9995;
/** From this sine of the angle z on, the angles x and z turn about one axis. */
const UPRIGHT = 0.9999999;

/** The turn `b` followed by the turn `a`. */
export function multiply([x, y, z, w]: Quaternion, [i, j, k, l]: Quaternion): Quaternion {
  return [
    w * i + x * l + y * k - z * j,
    w * j + y * l + z * i - x * k,
    w * k + z * l + x * j - y * i,
    w * l - x * i - y * j - z * k,
  ];
}

/** From one turn to another by the shorter way, at an even speed. @param share 0 is `from`, 1 is `to` */
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

/** The angles of a turn about x, then z, then y; radians. z is between -pi / 2 and pi / 2, at both ends x is 0. */
export function anglesYZX([x, y, z, w]: Quaternion): [x: number, y: number, z: number] {
  const rise = Math.min(Math.max(2 * (x * y + z * w), -1), 1);
  if (Math.abs(rise) > UPRIGHT) return [0, atan2(2 * (x * z + y * w), 1 - 2 * (x * x + y * y)), asin(rise)];
  return [
    atan2(2 * (x * w - y * z), 1 - 2 * (x * x + z * z)),
    atan2(2 * (y * w - x * z), 1 - 2 * (y * y + z * z)),
    asin(rise),
  ];
}
