/** Exponentiation with bit-identical results in every engine, see `sine.ts`. */

/** ln 2 as a sum of two terms. The first has 32 bits: its products with integers up to 2 ** 21 are exact. */
const [FIRST, SECOND] = [0.6931471803691238, 1.9082149292705877e-10];

/** e ** power; the relative error is below 4e-16. @param power -700 to 700 */
export function exp(power: number): number {
  const doublings = Math.round(power / FIRST);
  const rest = power - doublings * FIRST - doublings * SECOND;
  // Taylor series, smallest term first.
  let sum = 1;
  for (let term = 15; term > 0; --term) sum = 1 + (rest / term) * sum;
  return doubled(sum, doublings);
}

/**
 * base ** power; the relative error is below (1 + |power|) * 4e-16. Returns NaN for an invalid base.
 * @param base finite and not negative; `power` must be positive if it is 0
 */
export function pow(base: number, power: number): number {
  if (!(base > 0 && base < Infinity)) return base === 0 ? 0 : NaN;
  let [mantissa, exponent] = [base, 0];
  for (; mantissa > Math.SQRT2; ++exponent) mantissa /= 2;
  for (; mantissa < Math.SQRT1_2; --exponent) mantissa *= 2;
  const doublings = Math.round(power * exponent);
  const rest = (power * exponent - doublings) * Math.LN2 + power * log(mantissa);
  return doubled(exp(rest), doublings);
}

/** @param mantissa between the square roots of 1/2 and 2 */
function log(mantissa: number): number {
  const rest = (mantissa - 1) / (mantissa + 1);
  let sum = 0;
  for (let power = 21; power > 0; power -= 2) sum = 1 / power + rest * rest * sum;
  return 2 * rest * sum;
}

/** number * 2 ** times; each multiplication is exact. */
function doubled(number: number, times: number): number {
  let result = number;
  for (let left = Math.min(Math.abs(times), 1100); left > 0; --left) result *= times > 0 ? 2 : 0.5;
  return result;
}
