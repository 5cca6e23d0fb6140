/**
 * Median of the rounds with minimum and maximum; at least one value. An even number of values has the mean of the
 * middle two.
 *
 * @param {readonly number[]} values
 * @returns {{ value: number, range: [number, number], rounds: number }}
 */
export function spread(values) {
  const sorted = values.toSorted((a, b) => a - b);
  const value = (sorted[Math.floor((sorted.length - 1) / 2)] + sorted[Math.ceil((sorted.length - 1) / 2)]) / 2;
  return { value, range: [sorted[0], sorted[sorted.length - 1]], rounds: sorted.length };
}
