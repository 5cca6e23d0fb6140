/** Shadow casters of billboards: the lobes that they were baked from. */
import type { PuffShape } from '../shapes.ts';

/** All lengths in particle radii. */
export interface CasterTable {
  /** Number of variations. */
  readonly count: number;
  /** Maximum number of lobes per variation. */
  readonly lobeCount: number;
  /**
   * `lobeCount` lobes per variation, four floats each: centre and radius. Missing lobes are points inside the first
   * one.
   */
  readonly table: Float32Array;
}

export function castersOf(shapes: readonly PuffShape[]): CasterTable {
  const lobeCount = Math.max(...shapes.map(({ lobes }) => lobes.length));
  const table = shapes.flatMap(({ lobes }) => {
    const absent = Array.from({ length: lobeCount - lobes.length }, () => ({ center: lobes[0].center, radius: 0 }));
    return [...lobes, ...absent].flatMap(({ center, radius }) => [...center, radius]);
  });
  return { count: shapes.length, lobeCount, table: Float32Array.from(table) };
}
