/** What becomes of the rounds of several contestants. */

/** The middle one, or the mean of the middle two; at least one value. */
export function median(values: readonly number[]): number {
  const sorted = [...values].sort((a, b) => a - b);
  const middle = sorted.length >> 1;
  return sorted.length % 2 === 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}

/** Round by round, the first divided by the second: what slows the machine in a round slows both. */
export function ratios(dividends: readonly number[], divisors: readonly number[]): number[] {
  if (dividends.length !== divisors.length) {
    throw new Error(`${dividends.length} rounds cannot be divided by ${divisors.length}.`);
  }
  return dividends.map((dividend, round) => dividend / divisors[round]);
}

/** The slope of the straight line with the least squares through points over 1, 2, 3 and so on; at least two. */
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

/** The greatest divided by the least. */
export function spread(values: readonly number[]): number {
  return Math.max(...values) / Math.min(...values);
}
