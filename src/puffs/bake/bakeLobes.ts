/** Bakes lobe puffs to the tables that bodies and volumes use. */
import { bakingVariation, type LobeVariation } from './lobeVariation.ts';
import { CREASE_FILLET, middleOf, NORMAL_BLEND } from '../normals.ts';
import type { Lobe, PuffShape } from '../shapes.ts';
import { solidsOf, type PuffSolids } from './solids.ts';
import { finished, type Work } from '../../work.ts';

/** All lengths in particle radii. */
export interface LobePuffs {
  /** Maximum number of lobes per variation. */
  readonly lobeCount: number;
  /** Number of variations. */
  readonly count: number;
  /** Per variation: `lobeCount` lobes of four floats, centre and radius, then their centroid and a zero. */
  readonly table: Float32Array;
  readonly solids: PuffSolids;
  /** Radius of the bounding sphere of all puffs about the particle's centre. */
  readonly reach: number;
  /** Upper bound on the depth of visible points behind the centre plane, over all view directions. */
  readonly depth: number;
  /** Weight of the overall normal, see {@link NORMAL_BLEND}. */
  readonly blend: number;
  /** See {@link CREASE_FILLET}. */
  readonly fillet: number;
}

/** Position tolerance of rotated lobes: GPU sines have an error of about 2^-11. */
const ROTATION_TOLERANCE = 0.002;
/** Margin for visible points between the depth samples, and the step the bound is rounded up to, in radii. */
const DEPTH_SLACK = 0.05;
const DEPTH_STEP = 0.1;

/** @param shapes at least one, each with at most 12 lobes */
export function bakeLobes(shapes: readonly PuffShape[]): LobePuffs {
  return finished(bakingLobes(shapes));
}

/** As {@link bakeLobes}, in slices of about a millisecond. */
export function* bakingLobes(shapes: readonly PuffShape[]): Work<LobePuffs> {
  const max = Math.max(...shapes.map(({ lobes }) => lobes.length));
  const variations: LobeVariation[] = [];
  for (const { lobes } of shapes) variations.push(yield* bakingVariation(lobes));
  return together(variations, max);
}

function together(variations: readonly LobeVariation[], lobeCount: number): LobePuffs {
  return {
    lobeCount,
    count: variations.length,
    table: Float32Array.from(variations.flatMap(({ lobes }) => rowOf(lobes, lobeCount))),
    reach: Math.max(...variations.map(({ reach }) => reach)),
    depth: Math.ceil((Math.max(...variations.map(({ depth }) => depth)) + DEPTH_SLACK) / DEPTH_STEP) * DEPTH_STEP,
    solids: solidsOf(
      variations.map(({ lobes }) => lobes),
      { facesEye: false, tolerance: ROTATION_TOLERANCE, blur: 0 },
    ),
    blend: NORMAL_BLEND,
    fillet: CREASE_FILLET,
  };
}

/** A shape's row of the table. Missing lobes are points inside the first one, so that they have no effect. */
function rowOf(lobes: readonly Lobe[], lobeCount: number): number[] {
  const absent = Array.from({ length: lobeCount - lobes.length }, () => ({ center: lobes[0].center, radius: 0 }));
  return [...[...lobes, ...absent].flatMap(({ center, radius }) => [...center, radius]), ...middleOf(lobes), 0];
}
