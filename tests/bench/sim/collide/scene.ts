/** Smoke among moving rigids, measured by part of the step. */
import { emptyParticles, readParticles, withParticles, type Particles } from '../../support/snapshot.ts';
import { SIX_FORCES } from '../cloud.ts';
import type { MeasuredSimulator, Parts } from './module.ts';
import { poseAt, seededSmoke, seededSwings, type Swing } from './obstacles.ts';

export const COUNT = 10_000;
const STEP = 1 / 60;
/** Distance at which there are no rigids, metres. */
const FAR = 500;

/** The same forces as in collide.vsCompat. */
const FORCES = { ...SIX_FORCES, 'vortices.0.circulation': 2, 'vortices.0.reach': 4 };

/** 10,000 particles among rigids, and optionally as many far away. */
export class Scene {
  readonly measured: MeasuredSimulator;
  private readonly swings: readonly Swing[];
  private readonly start: Uint8Array;
  private seconds = 0;

  constructor(make: (capacity: number) => MeasuredSimulator, rigids: number, withFar = false) {
    this.measured = make(withFar ? 2 * COUNT : COUNT);
    this.swings = seededSwings(11, rigids);
    const { simulator } = this.measured;
    simulator.set(FORCES);
    for (const swing of this.swings) {
      simulator.addRigid({ kind: 'kinematic', shape: swing.shape, ...poseAt(swing, 0), friction: 0.2 });
    }
    const smoke = seededSmoke(COUNT, 5);
    this.start = withParticles(simulator, withFar ? joined(smoke, shifted(seededSmoke(COUNT, 6))) : smoke);
  }

  restart(): void {
    this.measured.simulator.restore(this.start);
    this.seconds = 0;
  }

  step(): Parts {
    this.seconds += STEP;
    this.swings.forEach((swing, index) => {
      const { position, rotation } = poseAt(swing, this.seconds);
      this.measured.simulator.moveRigid(index, position, rotation);
    });
    return this.measured.step();
  }

  /** Replaces its particles. */
  take(particles: Particles): void {
    const { simulator } = this.measured;
    simulator.restore(withParticles(simulator, particles));
  }

  get particles(): Particles {
    return readParticles(this.measured.simulator);
  }

  dispose(): void {
    this.measured.simulator.dispose();
  }
}

function shifted(particles: Particles): Particles {
  for (const column of [particles.x, particles.px]) {
    for (let i = 0; i < column.length; i++) column[i] += FAR;
  }
  return particles;
}

function joined(first: Particles, second: Particles): Particles {
  const all = emptyParticles(first.x.length + second.x.length);
  for (const name of Object.keys(all) as (keyof Particles)[]) {
    all[name].set(first[name]);
    all[name].set(second[name], first[name].length);
  }
  return all;
}
