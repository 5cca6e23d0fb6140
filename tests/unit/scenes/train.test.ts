/** The train: all puffs leave the chimney in the same phase of each half turn of the wheels. */
import { Quaternion, Vector3 } from 'three';
import { expect, test } from 'vitest';
import { findPreset, presetValues } from '../../../src/parameters/presets.ts';
import { AXLES, WHEEL_RADIUS } from '../../../src/scenes/models/locomotive.ts';
import { CHUFF, SPEED, train } from '../../../src/scenes/train.ts';
import { Simulation } from '../../../src/stage/simulation.ts';
import { readParticles } from '../../bench/support/snapshot.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

const STEP = 1 / 60;
const scene = train();

/** Phase of the first axle at a time, in half turns, 0 to 1. */
function phase(seconds: number): number {
  const spoke = new Vector3(1, 0, 0).applyQuaternion(new Quaternion(...scene.parts![0].pose(seconds).rotation));
  const halfRevolutions = -Math.atan2(spoke.y, spoke.x) / Math.PI;
  return halfRevolutions - Math.floor(halfRevolutions);
}

test('puffs keep time with the wheels', async () => {
  const factory = await loadVariant('physics');
  const simulation = new Simulation(factory, scene, presetValues(findPreset('train')!), 1e6);
  const phases: number[] = [];
  let bursts = 0;
  let wasSpawned = false;
  for (let step = 0; step < 600; step++) {
    simulation.advance(1);
    const { age, y } = readParticles(simulation.simulator);
    // From the chimney, not from the cylinders.
    const spawned = age.filter((seconds, i) => seconds <= STEP && y[i] > 0.9);
    if (spawned.length > 0 && !wasSpawned) bursts += 1;
    wasSpawned = spawned.length > 0;
    spawned.forEach((seconds) => phases.push(phase((step + 1) * STEP - seconds)));
  }
  expect(phases.length).toBeGreaterThan(100);
  // A third of the stroke, plus the rounding of ages.
  for (const at of phases) expect(at).toBeLessThan(0.37);
  expect(Math.max(...phases) - Math.min(...phases)).toBeGreaterThan(0.2);
  const revolutions = (600 * STEP * SPEED) / (2 * Math.PI * WHEEL_RADIUS);
  expect(Math.abs(bursts - 2 * revolutions)).toBeLessThanOrEqual(1);
  expect(CHUFF * 2).toBeCloseTo((2 * Math.PI * WHEEL_RADIUS) / SPEED, 9);
  simulation.dispose();
});

test('wheels roll without slipping: the point on the rail is at rest', () => {
  for (const seconds of [0.3, 1.7, 4.1]) {
    const [before, after] = [seconds, seconds + 1e-4].map((at) => scene.guide!(momentAt(at))[0]);
    const speed = Math.hypot(...[0, 1, 2].map((axis) => after.position[axis] - before.position[axis])) / 1e-4;
    const spokes = [seconds, seconds + 1e-4].map((at) =>
      new Vector3(1, 0, 0).applyQuaternion(new Quaternion(...scene.parts![0].pose(at).rotation)),
    );
    const rate = spokes[0].clone().cross(spokes[1]).z / 1e-4;
    expect(speed).toBeCloseTo(SPEED, 3);
    expect(speed + rate * WHEEL_RADIUS).toBeCloseTo(0, 2);
  }
  expect(scene.parts![0].pose(0).position).toEqual([AXLES[0], WHEEL_RADIUS, 0]);
});

function momentAt(seconds: number): Parameters<NonNullable<typeof scene.guide>>[0] {
  const nowhere = { position: [0, 0, 0], rotation: [0, 0, 0, 1] } as const;
  return { seconds, dt: STEP, control: () => 0, pose: () => nowhere };
}
