/** Fits a puff to any closed mesh: a few lobes whose union approximates it, and the mesh itself for billboards. */
import { requireOptions, ShapeError } from '../../../base/errors.ts';
import { BallCover } from './ballCover.ts';
import { closedMesh, type PlainMesh } from './closedMesh.ts';
import { inUnitBall } from '../lobes.ts';
import { copyingMesh } from './copyMesh.ts';
import type { PuffShape, Lobe } from '../shapes.ts';
import { voxelsOf, centreOf, depthsOf, type Voxels } from './voxels.ts';
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
 * With `puff.form=billboards`, puffs have the shape and the colours of the mesh itself, seen from +z.
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
  yield;
  const fitted = inUnitBall(balls);
  const own = yield* copyingMesh(mesh, closed, balls, fitted);
  return { shape: { name, lobes: fitted, mesh: own }, overlap };
}

/**
 * Approximates a solid by a few balls. Greedy selection adds the inscribed ball with the largest gain (after Bradshaw
 * and O'Sullivan, 'Adaptive Medial-Axis Approximation for Sphere-Tree Construction', 2004, whose candidates are also
 * medial). A pattern search then moves and resizes one ball at a time while the overlap of the volumes increases (Hooke
 * and Jeeves, 'Direct Search', 1961).
 */

/** Maximum number of candidate centres, and the candidate radii relative to the inscribed ball. */
const MAX_PLACES = 800;
const GROWTHS = [1, 1.12];
/** Minimum gain in overlap of an added ball. */
const MIN_GAIN = 0.0015;
/** Step sizes of the pattern search in radii of the unit ball: after each added ball, and at the end. */
const COARSE_STEPS = [0.05, 0.02];
const FINE_STEPS = [0.08, 0.04, 0.02, 0.01];
/** Maximum number of passes over all balls per step size. */
const ROUNDS = 12;

/**
 * @param max maximum number of balls
 * @throws ShapeError if the solid is too thin for any ball
 */
function* fittingBalls(voxels: Voxels, max: number): Work<Lobe[]> {
  const places = placesIn(voxels);
  if (places.length === 0) throw new ShapeError('The mesh is too thin: no ball of a useful size fits inside.');
  yield;
  const cover = new BallCover(voxels);
  const balls: Lobe[] = [];
  while (balls.length < max) {
    const next = yield* bestOf(places, cover);
    if (cover.overlapWith(next) < cover.overlap + MIN_GAIN) break;
    balls.push(next);
    cover.add(next);
    yield* improving(balls, cover, COARSE_STEPS);
  }
  yield* improving(balls, cover, FINE_STEPS);
  return balls;
}

/** Candidate balls at sampled inside voxels, of about the radius of the largest inscribed ball there. */
function placesIn(voxels: Voxels): Lobe[] {
  const { size, width } = voxels;
  const depths = depthsOf(voxels);
  const within = Array.from(depths.keys()).filter((voxel) => depths[voxel] > width);
  const stride = Math.max(1, Math.ceil(within.length / MAX_PLACES));
  const chosen = within.filter((_, index) => index % stride === 0);
  return chosen.flatMap((voxel) => {
    const place = [voxel % size, Math.floor(voxel / size) % size, Math.floor(voxel / size / size)];
    const [x, y, z] = place.map((index) => centreOf(index, width));
    return GROWTHS.map((growth): Lobe => ({ center: [x, y, z], radius: depths[voxel] * growth }));
  });
}

function* bestOf(places: readonly Lobe[], cover: BallCover): Work<Lobe> {
  let [best, max] = [places[0], -1];
  for (let index = 0; index < places.length; index++) {
    const overlap = cover.overlapWith(places[index]);
    if (overlap > max) [best, max] = [places[index], overlap];
    if (index % 100 === 99) yield;
  }
  return best;
}

function* improving(balls: Lobe[], cover: BallCover, steps: readonly number[]): Work<void> {
  for (const step of steps) {
    for (let round = 0, isBetter = true; isBetter && round < ROUNDS; round++) {
      isBetter = false;
      for (let ball = 0; ball < balls.length; ball++) {
        isBetter = improve(balls, ball, step, cover) || isBetter;
        yield;
      }
    }
  }
}

/** Applies the first move or resize of a ball that increases the overlap. Returns whether there is one. */
function improve(balls: Lobe[], index: number, step: number, cover: BallCover): boolean {
  for (const candidate of neighbours(balls[index], step)) {
    const [before, ball] = [cover.overlap, balls[index]];
    cover.remove(ball);
    cover.add(candidate);
    if (cover.overlap > before) {
      balls[index] = candidate;
      return true;
    }
    cover.remove(candidate);
    cover.add(ball);
  }
  return false;
}

function neighbours({ center: [x, y, z], radius }: Lobe, step: number): Lobe[] {
  const moved = [1, -1].flatMap((sign): Lobe[] => [
    { center: [x + sign * step, y, z], radius },
    { center: [x, y + sign * step, z], radius },
    { center: [x, y, z + sign * step], radius },
    { center: [x, y, z], radius: radius + sign * step },
  ]);
  return moved.filter((ball) => ball.radius > step);
}
