/** The JavaScript twin of the sim.vsJavaScript benchmark must match the simulator, or the comparison is meaningless. */
import { beforeAll, describe, expect, it } from 'vitest';
import { SIX_FORCES, seededCloud, type ForceValues } from '../../bench/sim/cloud.ts';
import { largestDifference, TwinSimulator } from '../../bench/sim/twin.ts';
import { readParticles, withParticles } from '../../bench/support/snapshot.ts';
import type { SimulatorFactory } from '../../../src/sim/load.ts';
import type { Simulator } from '../../../src/sim/simulator.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

const COUNT = 1000;
/** Metres: a hundred units in the last place of a coordinate of 5 m, after twelve steps of 0.1 m each. */
const TOLERANCE = 5e-5;
const STEPS = 12;

let factory: SimulatorFactory;

beforeAll(async () => {
  factory = await loadVariant('core');
});

/** Both with the same particles. */
function pair(values: ForceValues, lifetime?: number): [Simulator, TwinSimulator] {
  const simulator = factory.create({ capacity: COUNT, seed: 7 });
  simulator.set(values);
  const cloud = seededCloud(COUNT, 3, lifetime);
  simulator.restore(withParticles(simulator, cloud));
  return [simulator, new TwinSimulator(values, { seed: 7, drift: [0, 0, 0], phase: 0 }, cloud)];
}

describe('a saved state', () => {
  it('accepts other particles and returns them', () => {
    const simulator = factory.create({ capacity: 10, seed: 1 });
    const cloud = seededCloud(10, 1);
    simulator.restore(withParticles(simulator, cloud));
    expect(simulator.alive).toBe(10);
    expect(readParticles(simulator)).toEqual(cloud);
  });
});

describe('the twin', () => {
  it('moves particles as the simulator does', () => {
    const [simulator, twin] = pair(SIX_FORCES);
    const start = readParticles(simulator);
    for (let step = 0; step < STEPS; step++) {
      simulator.step();
      twin.step();
    }
    const moved = readParticles(simulator);
    expect(largestDifference(moved, twin.particles)).toBeLessThan(TOLERANCE);
    expect(largestDifference(moved, start)).toBeGreaterThan(0.1);
  });

  it.each<[string, Partial<ForceValues>]>([
    ['gravity', { 'gravity.acceleration': 0 }],
    ['buoyancy', { 'buoyancy.acceleration': 0 }],
    ['drag', { 'drag.rate': 0.01 }],
    ['wind', { 'forces.wind.x': 0 }],
    ['turbulence', { 'turbulence.speed': 0 }],
    ['evolution', { 'turbulence.evolution': 0 }],
    ['the vortex', { 'vortices.0.circulation': 0.001 }],
  ])('detects %s', (_, change) => {
    const [simulator] = pair(SIX_FORCES);
    const [, twin] = pair({ ...SIX_FORCES, ...change });
    for (let step = 0; step < STEPS; step++) {
      simulator.step();
      twin.step();
    }
    expect(largestDifference(readParticles(simulator), twin.particles)).toBeGreaterThan(20 * TOLERANCE);
  });

  it('ages, cools and removes particles as the simulator does', () => {
    const [simulator, twin] = pair(SIX_FORCES, 0.2);
    for (let step = 0; step < STEPS; step++) {
      simulator.step();
      twin.step();
    }
    const left = readParticles(simulator);
    expect(twin.alive).toBe(left.x.length);
    expect(twin.alive).toBeLessThan(COUNT);
    expect(twin.alive).toBeGreaterThan(0);
    expect([...twin.particles.attributes.subarray(0, twin.alive)]).toEqual([...left.attributes]);
    expect(largestDifference(left, twin.particles)).toBeLessThan(TOLERANCE);
  });
});
