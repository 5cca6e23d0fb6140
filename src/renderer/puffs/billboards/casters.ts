/** Shadow casters of billboards: the lobes that they were baked from, or discs around the silhouettes of pictures. */
import type { PuffLayers } from './layers.ts';
import { isOwnPicture } from './sides.ts';
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
  /** If puffs throw the silhouettes of their layers, which their only lobes contain: the radius of the largest one; else 0. */
  readonly silhouetteReach: number;
}

/**
 * @param shapes of the layers. If one of them is a picture of its own, all puffs throw silhouettes, because the shaders are the
 *   same for all.
 */
export function castersOf(shapes: readonly PuffShape[], layers: PuffLayers): CasterTable {
  const { count, pad, size } = layers;
  // Filtering moves the silhouette by less than a texel.
  const slack = (2 * pad) / size;
  if (shapes.some(isOwnPicture)) {
    const radii = layers.figures.map(({ outerRadius }) => outerRadius + slack);
    const table = Float32Array.from(radii.flatMap((radius) => [0, 0, 0, radius]));
    return { count, lobeCount: 1, table, silhouetteReach: Math.max(...radii) };
  }
  const lobeCount = Math.max(...shapes.map(({ lobes }) => lobes.length));
  const table = shapes.flatMap(({ lobes }) => {
    const absent = Array.from({ length: lobeCount - lobes.length }, () => ({ center: lobes[0].center, radius: 0 }));
    return [...lobes, ...absent].flatMap(({ center, radius }) => [...center, radius]);
  });
  return { count, lobeCount, table: Float32Array.from(table), silhouetteReach: 0 };
}
