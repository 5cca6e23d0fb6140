/** A puff from any closed mesh: the few lobes that together come nearest to it. */
import { ShapeError } from '../../preset/errors.ts';
import { BallCover } from './ballCover.ts';
import { closedMesh, type PlainMesh } from './closedMesh.ts';
import { fittingBalls } from './fitBalls.ts';
import { inUnitBall, MAX_LOBES } from '../lobes.ts';
import type { PuffShape } from '../shapes.ts';
import { voxelsOf } from './voxels.ts';
import { workedFor, type Work } from '../work.ts';

/** Voxels along each side of the grid in which lobes are fitted, and of the finer one in which the result is measured. */
const FIT_VOXELS = 40;
const MEASURE_VOXELS = 64;
/** Work between two breaths of the page. */
const BREATH_MS = 8;

/** A puff, and how near it comes to the mesh that it was made from. */
export interface FittedPuff {
  readonly shape: PuffShape;
  /** Volume that puff and mesh have in common, as a share of what either has: 1 where they are the same. */
  readonly overlap: number;
}

export interface FitOptions {
  /** What the puff is called. */
  readonly name?: string;
  /** The most lobes, 1 to 12; 12 where absent. */
  readonly lobes?: number;
  /** Aborting ends the work; the promise then rejects with the signal's reason. */
  readonly signal?: AbortSignal;
}

/**
 * Fits lobes to a closed mesh, a little at a time, so that a page goes on. The same mesh gives the same puff everywhere.
 * @throws ShapeError when the mesh is empty, open, too thin, not finite or has too many triangles
 */
export async function fitPuff(
  mesh: PlainMesh,
  { name = 'own', lobes = MAX_LOBES, signal }: FitOptions = {},
): Promise<FittedPuff> {
  if (!Number.isInteger(lobes) || lobes < 1 || lobes > MAX_LOBES) {
    throw new ShapeError(`A puff cannot have ${lobes} lobes: it takes a whole number from 1 to ${MAX_LOBES}.`);
  }
  const work = fitting(mesh, name, lobes);
  for (;;) {
    const fitted = workedFor(work, BREATH_MS);
    if (fitted) return fitted;
    await new Promise((resolve) => setTimeout(resolve));
    signal?.throwIfAborted();
  }
}

function* fitting(mesh: PlainMesh, name: string, lobes: number): Work<FittedPuff> {
  const closed = closedMesh(mesh);
  yield;
  const voxels = voxelsOf(closed, FIT_VOXELS);
  yield;
  const balls = yield* fittingBalls(voxels, lobes);
  const { overlap } = new BallCover(voxelsOf(closed, MEASURE_VOXELS), balls);
  return { shape: { name, lobes: inUnitBall(balls) }, overlap };
}
