/** The magic lamp: its smoke leaves the mouth and rises, and a ball in the smoke displaces it. */
import { Vector3 } from 'three';
import { beforeAll, expect, test } from 'vitest';
import { findPreset, presetValues } from '../../../src/parameters/presets.ts';
import { lamp } from '../../../src/scenes/lamp.ts';
import { lampModel } from '../../../src/scenes/models/lamp.ts';
import type { SimulatorFactory } from '../../../src/simulator/load.ts';
import { Drag } from '../../../src/stage/drag.ts';
import { Simulation } from '../../../src/stage/simulation.ts';
import { readParticles } from '../../bench/support/snapshot.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

const { radius } = lamp().handle!;
let factory: SimulatorFactory;

beforeAll(async () => {
  factory = await loadVariant('physics');
});

function burning(seconds: number): Simulation {
  const simulation = new Simulation(factory, lamp(), presetValues(findPreset('lamp')!), 1e6);
  simulation.advance(60 * seconds);
  return simulation;
}

/** Distance of each particle from a position, metres. */
function distances({ simulator }: Simulation, [a, b, c]: readonly number[]): number[] {
  const { x, y, z } = readParticles(simulator);
  return Array.from(x, (_, i) => Math.hypot(x[i] - a, y[i] - b, z[i] - c));
}

/** In the middle of the column. */
const PLACE = [1.07, 1.25, 0.1] as const;
const [START] = lamp().handle!.start;

test('a ball moved into the column contains no smoke', () => {
  const [held, free] = [burning(4), burning(4)];
  const drag = new Drag(held, lamp().handle!);
  for (let step = 1; step <= 90; step++) {
    drag.moveTo(new Vector3(START + (PLACE[0] - START) * Math.min(1, step / 60), PLACE[1], PLACE[2]));
    for (const simulation of [held, free]) simulation.advance(1);
    const ball = Array.from(held.simulator.rigidPoses(1).subarray(0, 3));
    expect(Math.min(...distances(held, ball))).toBeGreaterThan(radius - 1e-3);
  }
  const inside = (simulation: Simulation) =>
    distances(simulation, PLACE).filter((distance) => distance < 0.9 * radius).length;
  expect(inside(free)).toBeGreaterThan(8);
  expect(inside(held)).toBe(0);
  held.dispose();
  free.dispose();
});

test('young smoke is at the mouth, and older smoke is higher', () => {
  const simulation = burning(3);
  const { x, y, z, age } = readParticles(simulation.simulator);
  const [mouthX, mouthY, mouthZ] = lampModel().spout.position;
  const heights = [0, 0.5, 1, 1.5, 2].map((from) => {
    const some = Array.from(y).filter((_, i) => age[i] >= from && age[i] < from + 0.5);
    return some.reduce((sum, height) => sum + height, 0) / some.length;
  });
  expect(heights).toEqual(heights.toSorted((a, b) => a - b));
  const newest = Array.from(age, (seconds, i) => (seconds < 0.1 ? i : -1)).filter((i) => i >= 0);
  expect(newest.length).toBeGreaterThan(0);
  for (const i of newest) expect(Math.hypot(x[i] - mouthX, y[i] - mouthY, z[i] - mouthZ)).toBeLessThan(0.2);
  simulation.dispose();
});
