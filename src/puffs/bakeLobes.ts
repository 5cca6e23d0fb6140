/** Puffs of lobes as plain data: what bodies and volumes need of them. */
import { MOST_LOBES, reachOf, silhouetteRadius } from './lobes.ts';
import { orientationOf, turnedLobes } from './orientation.ts';
import { surfaceOf } from './patches.ts';
import { CREASE_FILLET, middleOf, NORMAL_BLEND } from './normals.ts';
import type { Lobe, PuffShape } from './shapes.ts';
import { bakeStartCaps, type StartCaps } from './startCaps.ts';

/** All lengths in particle radii. */
export interface LobePuffs {
  /** The most lobes that a variation has. */
  readonly lobeCount: number;
  /** Number of variations. */
  readonly count: number;
  /** For each variation `lobeCount` lobes of four numbers, centre and radius, and at the end their middle and a zero. */
  readonly table: Float32Array;
  readonly startCaps: StartCaps;
  /** Radius of the disc that has the silhouette's area, from all sides and over all variations. */
  readonly silhouetteRadius: number;
  /** Radius of the sphere about the particle's centre that holds any of the puffs. */
  readonly reach: number;
  /** Share of the overall normal, see {@link NORMAL_BLEND}. */
  readonly blend: number;
  /** See {@link CREASE_FILLET}. */
  readonly fillet: number;
}

/** Sides from which silhouettes are measured. */
const SIDES = 16;

/**
 * @param shapes at least one, each of at most {@link MOST_LOBES} lobes
 * @param litThreshold N . L from which a pixel's lit colour differs from its unlit one, -1..1
 * @throws RangeError when a shape has too many lobes
 */
export function bakeLobes(shapes: readonly PuffShape[], litThreshold: number): LobePuffs {
  const lobeCount = Math.max(...shapes.map(({ lobes }) => lobes.length));
  if (lobeCount > MOST_LOBES) throw new RangeError(`A puff has ${lobeCount} lobes; it takes at most ${MOST_LOBES}.`);
  return {
    lobeCount,
    count: shapes.length,
    table: Float32Array.from(shapes.flatMap(({ lobes }) => rowOf(lobes, lobeCount))),
    startCaps: bakeStartCaps(
      shapes.map(({ lobes }) => surfaceOf(lobes)),
      litThreshold,
    ),
    silhouetteRadius: meanSilhouette(shapes),
    reach: Math.max(...shapes.map(({ lobes }) => reachOf(lobes))),
    blend: NORMAL_BLEND,
    fillet: CREASE_FILLET,
  };
}

/** A shape's row of the table. Absent lobes are points within the first one, where they change nothing. */
function rowOf(lobes: readonly Lobe[], lobeCount: number): number[] {
  const absent = Array.from({ length: lobeCount - lobes.length }, () => ({ center: lobes[0].center, radius: 0 }));
  return [...[...lobes, ...absent].flatMap(({ center, radius }) => [...center, radius]), ...middleOf(lobes), 0];
}

function meanSilhouette(shapes: readonly PuffShape[]): number {
  const squares = shapes.flatMap(({ lobes }) =>
    Array.from({ length: SIDES }, (_, side) => {
      const seen = turnedLobes(orientationOf((side * 256) / SIDES, 2.4 * side), lobes);
      return silhouetteRadius(seen) ** 2;
    }),
  );
  return Math.sqrt(squares.reduce((sum, square) => sum + square, 0) / squares.length);
}
