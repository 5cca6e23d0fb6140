/** Statistics of the rounds of several contestants. */

/** The median, with the mean of the middle two for an even number; at least one value. */
export function median(values: readonly number[]): number {
  const sorted = [...values].sort((a, b) => a - b);
  const middle = sorted.length >> 1;
  return sorted.length % 2 === 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}

/** Quotients by round: load on the machine in a round affects both sides. */
export function ratios(dividends: readonly number[], divisors: readonly number[]): number[] {
  if (dividends.length !== divisors.length) {
    throw new Error(`${dividends.length} rounds cannot be divided by ${divisors.length}.`);
  }
  return dividends.map((dividend, round) => dividend / divisors[round]);
}

/** The slope of the least-squares line through the values at 1, 2, 3 and so on; at least two values. */
export function slope(values: readonly number[]): number {
  const middle = (values.length + 1) / 2;
  const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
  let [rise, run] = [0, 0];
  values.forEach((value, index) => {
    const way = index + 1 - middle;
    rise += way * (value - mean);
    run += way * way;
  });
  return rise / run;
}

/** The maximum divided by the minimum. */
export function spread(values: readonly number[]): number {
  return Math.max(...values) / Math.min(...values);
}
