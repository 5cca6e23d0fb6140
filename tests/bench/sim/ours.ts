/** Our simulator in WASM. */
import { loadSimulators, type SimulatorFactory } from '../../../src/simulator/load.ts';
import type { Simulator } from '../../../src/simulator/simulator.ts';
import { time } from '../support/figures.ts';
import { readParticles, withParticles, type Particles } from '../support/snapshot.ts';
import { SIX_FORCES, seededCloud } from './cloud.ts';
import type { Contestant } from './contestant.ts';

/** Seed of the turbulence. */
const SEED = 7;

export class Wasm implements Contestant {
  readonly name: string;
  readonly simulator: Simulator;
  /** The saved initial state of every round, including parameters. */
  readonly start: Uint8Array;

  private constructor(name: string, simulator: Simulator, start: Uint8Array) {
    this.name = name;
    this.simulator = simulator;
    this.start = start;
    this.restart();
  }

  /** A simulator filled with the seeded cloud. */
  static async create(count: number, forces: Readonly<Record<string, number>> = SIX_FORCES): Promise<Wasm> {
    return Wasm.of(await loadSimulators({ physics: false }), 'wasm', seededCloud(count, 3), forces);
  }

  /** A simulator of `factory` with these particles. */
  static of(
    factory: SimulatorFactory,
    name: string,
    particles: Particles,
    forces: Readonly<Record<string, number>>,
  ): Wasm {
    const simulator = factory.create({ capacity: particles.x.length, seed: SEED });
    simulator.set(forces);
    return new Wasm(name, simulator, withParticles(simulator, particles));
  }

  restart(): void {
    this.simulator.restore(this.start);
  }

  advance(steps: number): number {
    return time(() => this.simulator.step(steps));
  }

  particles(): Particles {
    return readParticles(this.simulator);
  }

  places(): Float32Array {
    return placesOf(this.particles());
  }

  dispose(): void {
    this.simulator.dispose();
  }
}

function placesOf({ x, y, z }: Particles): Float32Array {
  return Float32Array.from({ length: 3 * x.length }, (_, i) => [x, y, z][i % 3][(i / 3) | 0]);
}
