/** three-nebula with the behaviours closest to the six forces. */
import { CurlNoise, Emitter, Force, Life, Mass, Radius, Rate, Span, System, Vector3D, Vortex } from 'three-nebula';
import { time } from '../support/figures.ts';
import type { Particles } from '../support/snapshot.ts';
import { SIX_FORCES } from './cloud.ts';
import type { Contestant } from './contestant.ts';
import { STEP, TYPICAL_DISTANCE, angularRate } from './nearest.ts';

/** Factor that Force applies to its numbers. */
const MEASURE = 100;
/** Root mean square of the curl noise. The acceleration is divided by it to give the same speed against the drag. */
const CURL = 1;

export class Nebula implements Contestant {
  readonly name = 'nebula';
  private readonly system = new System(0, undefined, 7);
  private readonly emitter = new Emitter();

  constructor(cloud: Particles) {
    const count = cloud.x.length;
    this.emitter
      .setRate(new Rate(new Span(count), new Span(0)))
      .setInitializers([new Mass(1), new Radius(0.2), new Life(1e6)])
      .setBehaviours(behaviours());
    // Between two steps of the system, of any duration, the speed is multiplied by 1 - damping.
    this.emitter.damping = 1 - Math.exp(-SIX_FORCES['drag.rate'] * STEP);
    this.system.addEmitter(this.emitter);
    this.emitter.setTotalEmitTimes(1).experimental_emit();
    this.advance(1);
    this.emitter.particles.forEach(({ position, velocity }, i) => {
      position.set(cloud.x[i], cloud.y[i], cloud.z[i]);
      velocity.set(0, 0, 0);
    });
  }

  get alive(): number {
    return this.emitter.particles.length;
  }

  restart(): void {}

  /** Without a renderer: updates the particles only. */
  advance(steps: number): number {
    return time(() => {
      for (let step = 0; step < steps; step++) void this.system.update(STEP);
    });
  }

  places(): Float32Array {
    const places = new Float32Array(3 * this.alive);
    this.emitter.particles.forEach(({ position: { x, y, z } }, i) => places.set([x, y, z], 3 * i));
    return places;
  }

  dispose(): void {
    this.emitter.particles.length = 0;
    this.system.destroy();
  }
}

/** The emitter's damping is the drag. The buoyancy does not cool, and the vortex has no core. */
function behaviours() {
  const drag = SIX_FORCES['drag.rate'];
  const push = (x: number, y: number, z: number) => new Force(x / MEASURE, y / MEASURE, z / MEASURE);
  const axis = (['x', 'y', 'z'] as const).map((name) => SIX_FORCES[`vortices.0.axis.${name}`]);
  return [
    push(0, -SIX_FORCES['gravity.acceleration'], 0),
    push(0, SIX_FORCES['buoyancy.acceleration'], 0),
    push(SIX_FORCES['forces.wind.x'] * drag, 0, SIX_FORCES['forces.wind.z'] * drag),
    new CurlNoise(1 / SIX_FORCES['turbulence.scale'], (SIX_FORCES['turbulence.speed'] * drag) / CURL, 7),
    new Vortex(
      new Vector3D(SIX_FORCES['vortices.0.position.x'], 0, 0),
      new Vector3D(...axis),
      angularRate(TYPICAL_DISTANCE) * TYPICAL_DISTANCE ** 2 * drag,
      0,
      2,
    ),
  ];
}
