/** The rocket: its exhaust spreads on the ground in a growing ring, and no smoke enters the ground. */
import { Vector3 } from 'three';
import { expect, test } from 'vitest';
import { findPreset, presetValues } from '../../../src/parameters/presets.ts';
import { IGNITION, rocket } from '../../../src/scenes/rocket.ts';
import { OrbitCamera } from '../../../src/stage/orbit.ts';
import { Simulation } from '../../../src/stage/simulation.ts';
import { readParticles } from '../../bench/support/snapshot.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

const STEPS_A_SECOND = 60;
/** Metres, of the model. */
const ROCKET_HEIGHT = 1.9;
const GROUND = rocket().rig['colliders.0.position.y'];

test('the ring of cloud grows evenly to all sides from ignition until the rocket has left', async () => {
  const factory = await loadVariant('physics');
  const simulation = new Simulation(factory, rocket(), presetValues(findPreset('rocket')!), 1e6);
  simulation.advance(IGNITION * STEPS_A_SECOND);
  expect(simulation.simulator.alive).toBe(0);
  const radii: number[] = [];
  for (let half = 1; half <= 7; half++) {
    simulation.advance(STEPS_A_SECOND / 2);
    const { x, y, z } = readParticles(simulation.simulator);
    expect(Math.min(...y)).toBeGreaterThan(GROUND - 1e-3);
    const near = Array.from(x, (_, i) => [x[i], z[i]]).filter((_, i) => y[i] < GROUND + 0.7);
    const distances = near.map(([a, b]) => Math.hypot(a, b)).toSorted((a, b) => a - b);
    radii.push(distances[Math.floor(0.9 * distances.length)]);
    const middle = [0, 1].map((axis) => near.reduce((sum, place) => sum + place[axis], 0) / near.length);
    if (half > 2) expect(Math.hypot(...middle)).toBeLessThan(0.2 * radii.at(-1)!);
  }
  expect(radii).toEqual(radii.toSorted((a, b) => a - b));
  expect(radii[0]).toBeLessThan(1.6);
  expect(radii.at(-1)!).toBeGreaterThan(2 * radii[0]);
  simulation.dispose();
});

test('the rocket and the ground always stay in the picture', () => {
  const scene = rocket();
  const lens = new OrbitCamera(scene);
  lens.setSize(1440, 900);
  for (let second = 0; second <= 18; second += 0.25) {
    lens.moveTo(second);
    const [, up] = scene.guide!(momentAt(second))[0].position;
    for (const height of [0, up, up + ROCKET_HEIGHT]) {
      expect(Math.abs(new Vector3(0, height, 0).project(lens.camera).y), `${height} m after ${second} s`).toBeLessThan(
        1,
      );
    }
  }
});

test('the rocket returns to its start', () => {
  const { guide, rigids } = rocket();
  const at = (seconds: number) => guide!(momentAt(seconds))[0].position;
  expect(at(1)[1]).toBeCloseTo(rigids[0].position[1], 9);
  expect(at(6)[1]).toBeGreaterThan(6);
  expect(at(17)[1]).toBeCloseTo(at(0)[1], 9);
  for (let step = 0; step < 2400; step++) {
    // At most 5.5 m/s, without a jump.
    expect(Math.abs(at((step + 1) / 60)[1] - at(step / 60)[1])).toBeLessThan(6 / 60);
  }
});

/** The arguments of a guide at a time. */
function momentAt(seconds: number) {
  const nowhere = { position: [0, 0, 0], rotation: [0, 0, 0, 1] } as const;
  return { seconds, dt: 1 / 60, control: () => 0, pose: () => nowhere };
}
