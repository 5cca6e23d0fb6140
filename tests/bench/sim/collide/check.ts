/** Our collisions and Rapier's queries do the same work: both find the same particles at the same rigids. */
import { demand } from '../../support/figures.ts';
import type { MeasuredSimulator } from './module.ts';
import { COUNT, Scene } from './scene.ts';
import { RIGIDS } from './obstacles.ts';

/** Largest relative motion of a particle and a rigid within a step, metres. Only our collisions handle it. */
const WAY = 0.06;
const WARMING_STEPS = 5;

/** Numbers of particles. */
export interface Work {
  /** Their box touches a rigid's. */
  asked: number;
  /** They overlap according to Rapier, in the run without collisions. */
  overlapping: number;
  pushed: number;
}

/**
 * Runs one step with collisions and one without, from the same particles. Every pushed particle must be near a rigid
 * according to Rapier, every particle that overlaps one must be pushed, and all of them must be among the queried ones.
 *
 * @param limit Metres; the radius of the largest particle.
 */
export function compareWork(make: (capacity: number) => MeasuredSimulator, limit: number): Work {
  const [scene, unhindered] = [new Scene(make, RIGIDS), new Scene(make, 0)];
  scene.restart();
  unhindered.restart();
  for (let step = 0; step < WARMING_STEPS; step++) {
    scene.step();
    // Keeps the age of its air equal, although its particles are replaced.
    unhindered.step();
  }
  unhindered.take(scene.particles);
  scene.step();
  unhindered.step();
  const [after, free] = [scene.particles, unhindered.particles];
  scene.take(free);
  const { rapier } = scene.measured;
  const everybody = Uint32Array.from({ length: COUNT }, (_, index) => index);
  const distances = rapier.distances(everybody, 2 * WAY + limit);
  const near = new Set(rapier.findInTouchedBoxes());
  const work: Work = { asked: near.size, overlapping: 0, pushed: 0 };
  for (let i = 0; i < COUNT; i++) {
    const gap = distances[i] - free.size[i];
    const isPushed = after.x[i] !== free.x[i] || after.y[i] !== free.y[i] || after.z[i] !== free.z[i];
    if (isPushed) work.pushed++;
    if (gap < 0) work.overlapping++;
    demand(!isPushed || gap < WAY, `particle ${i} was pushed ${gap} m away from all rigids`);
    demand(isPushed || gap > -0.02 * free.size[i], `particle ${i} overlaps a rigid by ${-gap} m`);
    demand(gap >= 0 || near.has(i), `particle ${i} overlaps a rigid by ${-gap} m and is not among those asked`);
  }
  requireSameDistances(rapier, near, distances, limit);
  demand(work.pushed > 0.01 * COUNT, `${work.pushed} particles were pushed`);
  demand(work.overlapping > 0.5 * work.pushed, `${work.overlapping} overlap, ${work.pushed} were pushed`);
  scene.dispose();
  unhindered.dispose();
  return work;
}

/** The limited queries must give the same results as the unlimited ones where it matters. */
function requireSameDistances(
  rapier: MeasuredSimulator['rapier'],
  near: ReadonlySet<number>,
  distances: Float32Array,
  limit: number,
): void {
  const asked = Uint32Array.from(near);
  rapier.distances(asked, limit).forEach((distance, place) => {
    const all = distances[asked[place]];
    demand(all >= limit || Math.abs(distance - all) < 1e-5, `distances ${distance} and ${all} to one particle`);
  });
}
