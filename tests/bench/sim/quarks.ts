/** three.quarks with the behaviours closest to the six forces. */
import {
  ApplyForce,
  ConstantValue,
  LimitSpeedOverLife,
  OrbitOverLife,
  ParticleSystem,
  PointEmitter,
  TurbulenceField,
  Vector3,
  type Behavior,
  type FunctionValueGenerator,
} from 'three.quarks';
import { MeshBasicMaterial, Scene } from 'three';
import { time } from '../support/figures.ts';
import type { Particles } from '../support/snapshot.ts';
import { SIX_FORCES } from './cloud.ts';
import type { Contestant } from './contestant.ts';

/** Seconds. */
const STEP = 1 / 60;
/** Metres: approximate mean distance of the seeded cloud from the vortex axis. */
const TYPICAL_DISTANCE = 3.8;
/** LimitSpeedOverLife removes `dampen` * 20 of the excess speed per second. */
const DAMPEN_PER_SECOND = 20;
/** Root mean square of the noise. The acceleration is divided by it to give the same speed against the drag. */
const NOISE = 0.25;

/** A constant works as a curve over life and is cheaper, but the types require a curve. */
const NONE = new ConstantValue(0) as unknown as FunctionValueGenerator;

export class Quarks implements Contestant {
  readonly name = 'quarks';
  private readonly scene = new Scene();
  private readonly system: ParticleSystem;

  constructor(cloud: Particles) {
    const count = cloud.x.length;
    this.system = new ParticleSystem({
      looping: false,
      duration: 1e6,
      startLife: new ConstantValue(1e6),
      startSpeed: new ConstantValue(0),
      worldSpace: true,
      emissionOverTime: new ConstantValue(0),
      emissionBursts: [{ time: 0, count: new ConstantValue(count), cycle: 1, interval: 0, probability: 1 }],
      shape: new PointEmitter(),
      material: new MeshBasicMaterial(),
      behaviors: behaviours(),
    });
    this.scene.add(this.system.emitter);
    this.advance(1);
    this.system.particles.forEach(({ position, velocity }, i) => {
      position.set(cloud.x[i], cloud.y[i], cloud.z[i]);
      velocity.set(0, 0, 0);
    });
  }

  get alive(): number {
    return this.system.particleNum;
  }

  restart(): void {}

  /** Only the system's own update, without filling the buffers as in BatchedRenderer.update. */
  advance(steps: number): number {
    const system = this.system as unknown as { update(delta: number): void };
    return time(() => {
      for (let step = 0; step < steps; step++) system.update(STEP);
    });
  }

  places(): Float32Array {
    const places = new Float32Array(3 * this.alive);
    for (let i = 0; i < this.alive; i++) {
      const { x, y, z } = this.system.particles[i].position;
      places.set([x, y, z], 3 * i);
    }
    return places;
  }

  dispose(): void {
    this.system.dispose();
    this.system.particles.length = 0;
  }
}

/** In the order of SIX_FORCES. The buoyancy does not cool, and the vortex rotates all particles at the same rate. */
function behaviours(): Behavior[] {
  const drag = SIX_FORCES['drag.rate'];
  const wind = new Vector3(SIX_FORCES['forces.wind.x'], 0, SIX_FORCES['forces.wind.z']);
  const axis = (['x', 'y', 'z'] as const).map((name) => SIX_FORCES[`vortices.0.axis.${name}`]);
  const swirl = (SIX_FORCES['turbulence.speed'] * drag) / (Math.sqrt(3) * NOISE);
  const side = SIX_FORCES['turbulence.scale'];
  const pace = SIX_FORCES['turbulence.evolution'];
  // Of the vortex outside its core, rad/s.
  const rate = SIX_FORCES['vortices.0.circulation'] / (2 * Math.PI * TYPICAL_DISTANCE ** 2);
  return [
    new ApplyForce(new Vector3(0, -1, 0), new ConstantValue(SIX_FORCES['gravity.acceleration'])),
    new ApplyForce(new Vector3(0, 1, 0), new ConstantValue(SIX_FORCES['buoyancy.acceleration'])),
    new ApplyForce(wind, new ConstantValue(drag)),
    new TurbulenceField(
      new Vector3(side, side, side),
      SIX_FORCES['turbulence.octaves'],
      new Vector3(swirl, swirl, swirl),
      new Vector3(pace, pace, pace),
    ),
    new OrbitOverLife(new ConstantValue(rate), new Vector3(...axis).normalize()),
    new LimitSpeedOverLife(NONE, drag / DAMPEN_PER_SECOND),
  ];
}
