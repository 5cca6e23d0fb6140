/**
 * Sine, cosine and length with bit-identical results in every engine. ECMAScript does not define the last bits of
 * `Math.sin`, `Math.hypot`, `**` and similar functions, so a simulation that uses them diverges between engines. The
 * functions in this folder only use + - * / sqrt abs sign min max round, whose results are fully specified.
 */

/** Pi / 2 as a sum of two terms. The first has 31 bits: its products with integers up to 2 ** 22 are exact. */
const [FIRST, SECOND] = [1.5707963267341256, 6.077100506506192e-11];

/** @param angle radians; the error is below 3e-16 up to 6e6 rad */
export const sin = (angle: number): number => wave(angle, 0);

/** @param angle radians; the error is below 3e-16 up to 6e6 rad */
export const cos = (angle: number): number => wave(angle, 1);

/** Length of a vector. Its square must not overflow. */
export function hypot(...vector: readonly number[]): number {
  return Math.sqrt(vector.reduce((sum, part) => sum + part * part, 0));
}

/** sin(angle + ahead * pi / 2). */
function wave(angle: number, ahead: number): number {
  const quarters = Math.round(angle / FIRST);
  const rest = angle - quarters * FIRST - quarters * SECOND;
  const isCosine = (quarters + ahead) & 1;
  // Taylor series, smallest term first.
  let sum = 1;
  for (let power = 19 - isCosine; power > 1; power -= 2) sum = 1 - ((rest * rest) / (power * (power - 1))) * sum;
  return (isCosine || rest) * ((quarters + ahead) & 2 ? -sum : sum);
}
