/** Puffs of lobes as plain data: what bodies and volumes need of them. */
import { bakingVariation, type LobeVariation } from './lobeVariation.ts';
import { CREASE_FILLET, middleOf, NORMAL_BLEND } from '../normals.ts';
import type { Lobe, PuffShape } from '../shapes.ts';
import { solidsOf, type PuffSolids } from './solids.ts';
import { joined, type StartCaps } from './startCaps.ts';
import { finished, type Work } from '../work.ts';

/** All lengths in particle radii. */
export interface LobePuffs {
  /** The most lobes that a variation has. */
  readonly lobeCount: number;
  /** Number of variations. */
  readonly count: number;
  /** For each variation `lobeCount` lobes of four numbers, centre and radius, and at the end their middle and a zero. */
  readonly table: Float32Array;
  readonly startCaps: StartCaps;
  readonly solids: PuffSolids;
  /** See {@link latestCap}. */
  readonly latestCap: number;
  /** Radius of the sphere about the particle's centre that holds any of the puffs. */
  readonly reach: number;
  /** How deep behind the centre plane something of a puff can be seen, from whatever side. */
  readonly depth: number;
  /** Share of the overall normal, see {@link NORMAL_BLEND}. */
  readonly blend: number;
  /** See {@link CREASE_FILLET}. */
  readonly fillet: number;
}

/** The sines of a graphics processor are right to some 2^-11, and so is where it turns a lobe to. */
const ROTATION_TOLERANCE = 0.002;
/** What may be seen between the places where depths are measured, in radii; and to what the bound is rounded up. */
const DEPTH_SLACK = 0.05;
const DEPTH_STEP = 0.1;

/**
 * @param shapes at least one, each of at most 12 lobes
 * @param litThreshold N . L from which a pixel's lit colour differs from its unlit one, -1..1
 */
export function bakeLobes(shapes: readonly PuffShape[], litThreshold: number): LobePuffs {
  return finished(bakingLobes(shapes, litThreshold));
}

/** As {@link bakeLobes}, in pieces of about a millisecond. */
export function* bakingLobes(shapes: readonly PuffShape[], litThreshold: number): Work<LobePuffs> {
  const max = Math.max(...shapes.map(({ lobes }) => lobes.length));
  const variations: LobeVariation[] = [];
  for (const { lobes } of shapes) variations.push(yield* bakingVariation(lobes, litThreshold));
  return together(variations, max);
}

function together(variations: readonly LobeVariation[], lobeCount: number): LobePuffs {
  return {
    lobeCount,
    count: variations.length,
    table: Float32Array.from(variations.flatMap(({ lobes }) => rowOf(lobes, lobeCount))),
    startCaps: joined(variations.map(({ startCaps }) => startCaps)),
    latestCap: Math.max(...variations.map((variation) => variation.latestCap)),
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

/** A shape's row of the table. Absent lobes are points within the first one, where they change nothing. */
function rowOf(lobes: readonly Lobe[], lobeCount: number): number[] {
  const absent = Array.from({ length: lobeCount - lobes.length }, () => ({ center: lobes[0].center, radius: 0 }));
  return [...[...lobes, ...absent].flatMap(({ center, radius }) => [...center, radius]), ...middleOf(lobes), 0];
}
