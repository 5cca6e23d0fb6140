/** Tangent and inverse trigonometric functions with bit-identical results in every engine, see `sine.ts`. */
import { cos, sin } from './sine.ts';

/** @param angle radians */
export function tan(angle: number): number {
  return sin(angle) / cos(angle);
}

/** Angle from +x to (x, y) towards +y, -pi to pi rad; the error is below 5e-16. Returns 0 for the zero vector. */
export function atan2(y: number, x: number): number {
  const [rise, run] = [Math.abs(y), Math.abs(x)];
  const isSteep = rise > run;
  const slope = rise === run ? Math.sign(run) : isSteep ? run / rise : rise / run;
  const acute = isSteep ? Math.PI / 2 - atan(slope) : atan(slope);
  const angle = x < 0 ? Math.PI - acute : acute;
  return y < 0 ? -angle : angle;
}

/** Result in radians; the error is below 4e-16. @param sine -1 to 1 */
export function asin(sine: number): number {
  return atan2(sine, Math.sqrt((1 - sine) * (1 + sine)));
}

/** Result in radians; the error is below 5e-16. @param cosine -1 to 1 */
export function acos(cosine: number): number {
  return atan2(Math.sqrt((1 - cosine) * (1 + cosine)), cosine);
}

/** @param slope 0 to 1 */
function atan(slope: number): number {
  // Angles above pi / 8 are reduced by pi / 4, so that the series converges quickly.
  const isFlat = slope < 0.41;
  const rest = isFlat ? slope : (slope - 1) / (slope + 1);
  let sum = 0;
  for (let power = 41; power > 0; power -= 2) sum = 1 / power - rest * rest * sum;
  return isFlat ? rest * sum : Math.PI / 4 + rest * sum;
}
