/** Fits a puff to any closed mesh: a few lobes whose union approximates it. */
import { requireOptions, ShapeError } from '../../../base/errors.ts';
import { BallCover } from './ballCover.ts';
import { closedMesh, type PlainMesh } from './closedMesh.ts';
import { fittingBalls } from './fitBalls.ts';
import { inUnitBall } from '../lobes.ts';
import type { PuffShape } from '../shapes.ts';
import { voxelsOf } from './voxels.ts';
import { workedFor, type Work } from '../../../base/work.ts';
import { MAX_LOBES } from '../../../base/constants.ts';

/** Voxels along each side of the grid for fitting, and of the finer grid that measures the result. */
const FIT_VOXELS = 40;
const MEASURE_VOXELS = 64;
/** Length of a work slice, after which the event loop runs. */
const BREATH_MS = 8;

/** A fitted puff and the quality of the fit. */
export interface FittedPuff {
  readonly shape: PuffShape;
  /** Intersection over union of the volumes of puff and mesh, 0 to 1. */
  readonly overlap: number;
}

export interface FitOptions {
  /** Name of the puff. */
  readonly name?: string;
  /** Maximum number of lobes, 1 to 12. Default 12. */
  readonly lobes?: number;
  /** Aborts the work. The promise then rejects with the signal's reason. */
  readonly signal?: AbortSignal;
}

/**
 * Fits lobes to a closed mesh, in slices of 8 ms so that the page stays responsive. Deterministic in every browser.
 * @throws ShapeError if the mesh is empty, open, too thin, not finite or has too many triangles, or `lobes` is invalid
 */
export async function fitPuff(mesh: PlainMesh, options: FitOptions = {}): Promise<FittedPuff> {
  requireOptions('fitPuff', options, ['name', 'lobes', 'signal']);
  const { name = 'own', lobes = MAX_LOBES, signal } = options;
  if (!Number.isInteger(lobes) || lobes < 1 || lobes > MAX_LOBES) {
    throw new ShapeError(`A puff cannot have ${lobes} lobes: use a whole number from 1 to ${MAX_LOBES}.`);
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
