/** Those who are compared, behind one face. */

/** Holds a number of particles under the six forces and can advance them. */
export interface Contestant {
  /** Names its figures. */
  readonly name: string;
  /** Goes back to the seeded particles; the engines of others go on instead, for whom that takes longer than a round. */
  restart(): void | Promise<void>;
  /** Advances by so many steps and returns the milliseconds that this took. */
  advance(steps: number): number | Promise<number>;
  /** Where its particles are, metres, x y z by turns; undefined for one that has only a fingerprint, or no places. */
  places?(): Float32Array;
  /** Gives its memory back. */
  dispose(): void;
}

/** Mean distance (m) between the places before and after; both hold the same particles in the same order. */
export function meanDistance(before: Float32Array, after: Float32Array): number {
  let sum = 0;
  for (let i = 0; i < before.length; i += 3) {
    sum += Math.hypot(after[i] - before[i], after[i + 1] - before[i + 1], after[i + 2] - before[i + 2]);
  }
  return (sum * 3) / before.length;
}
