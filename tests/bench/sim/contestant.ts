/** The common interface of all contestants. */

/** Holds particles under the six forces and advances them. */
export interface Contestant {
  /** Used in the names of its figures. */
  readonly name: string;
  /**
   * Resets to the seeded particles. Third-party engines continue instead, because a reset takes longer than a round.
   */
  restart(): void | Promise<void>;
  /** Advances by this number of steps and returns the elapsed milliseconds. */
  advance(steps: number): number | Promise<number>;
  /**
   * Positions of its particles, metres, x y z interleaved; undefined for contestants with only a hash or no positions.
   */
  places?(): Float32Array;
  dispose(): void;
}

/** Mean distance (m) between positions before and after, of the same particles in the same order. */
export function meanDistance(before: Float32Array, after: Float32Array): number {
  let sum = 0;
  for (let i = 0; i < before.length; i += 3) {
    sum += Math.hypot(after[i] - before[i], after[i + 1] - before[i + 1], after[i + 2] - before[i + 2]);
  }
  return (sum * 3) / before.length;
}
