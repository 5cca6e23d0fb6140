/** The dragon: fire leaves the open mouth, on each beat of the timeline. */
import { Vector3 } from 'three';
import { expect, test } from 'vitest';
import { BEAT, BREATH } from '../../../src/parameters/byScene/dragon.ts';
import { readTimeline } from '../../../src/parameters/timeline.ts';
import { findPreset, presetValues } from '../../../src/parameters/presets.ts';
import { fetchTimelineText } from '../../../src/renderer/extraPasses.ts';
import { dragon } from '../../../src/scenes/dragon.ts';
import { LIPS } from '../../../src/scenes/models/dragon/dragonHead.ts';
import type { Placement, Vector } from '../../../src/scenes/scene.ts';
import { multiply } from '../../../src/simulator/exact/quaternion.ts';
import { rotate, type Quaternion } from '../../../src/simulator/exact/rotation.ts';
import { Simulation } from '../../../src/stage/simulation.ts';
import { OrbitCamera } from '../../../src/stage/orbit.ts';
import { readParticles } from '../../bench/support/snapshot.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

const values = presetValues(findPreset('dragon')!);
const { timeline, problems } = readTimeline(values.timeline!);
const scene = dragon();
const poseOf = (name: string, step: number): Placement =>
  scene.parts!.find((part) => part.name === name)!.pose(step / 60);

/** How far the jaw is from closed, in radians. */
function opening(step: number): number {
  const [x, y, z, w] = poseOf('Head', step).rotation;
  const back: Quaternion = [-x, -y, -z, w];
  return 2 * Math.acos(Math.min(1, Math.abs(multiply(back, poseOf('Jaw', step).rotation)[3])));
}

test('the mouth is open at each burst, and closed for most of the time between', () => {
  expect(problems).toEqual([]);
  expect(timeline.bursts.length).toBeGreaterThan(10);
  for (let beat = 0; beat < 5; beat++) {
    for (const { step } of timeline.bursts) expect(opening(beat * timeline.length + step)).toBeGreaterThan(0.55);
  }
  const closed = Array.from({ length: timeline.length }, (_, step) => opening(step)).filter((angle) => angle < 0.01);
  expect(closed.length).toBeGreaterThan(timeline.length / 2);
});

test('the chest is full when the fire begins, and empty when it ends', () => {
  const [first, last] = [timeline.bursts[0].step, timeline.bursts.at(-1)!.step];
  const swell = (step: number) => poseOf('Chest', step).position[0];
  expect(swell(first)).toBeGreaterThan(
    0.9 * Math.max(...Array.from({ length: timeline.length }, (_, at) => swell(at))),
  );
  expect(swell(last)).toBeLessThan(0.1 * swell(first));
});

test('fire leaves the mouth along the head, wherever the head is, and cools on its way', async () => {
  await fetchTimelineText(values);
  const simulation = new Simulation(await loadVariant('core'), scene, values, 1e6);
  // Late enough that the head has swayed to a side.
  const { step } = timeline.bursts[0];
  simulation.advance(2 * timeline.length + step + 2);
  const { position, rotation } = poseOf('Head', 2 * timeline.length + step + 2);
  const lips = rotate(rotation, LIPS).map((along, axis) => along + position[axis]);
  const forwards = rotate(rotation, [1, 0, 0]);
  const { x, y, z, age, temperature } = readParticles(simulation.simulator);
  const fresh = [...age.keys()].filter((index) => age[index] < 0.05 && temperature[index] > 0.8);
  expect(fresh.length).toBeGreaterThan(5);
  for (const index of fresh) {
    const way = [x[index], y[index], z[index]].map((along, axis) => along - lips[axis]) as unknown as Vector;
    const along = way.reduce((sum, part, axis) => sum + part * forwards[axis], 0);
    expect(Math.hypot(...way)).toBeLessThan(0.5);
    expect(along).toBeGreaterThan(-0.05);
  }
  // A second after the last burst the fire is smoke.
  simulation.advance(timeline.bursts.at(-1)!.step - step + 60);
  const smoke = readParticles(simulation.simulator);
  const fire = [...smoke.x.keys()].filter((index) => smoke.x[index] > 2);
  expect(fire.length).toBeGreaterThan(20);
  for (const index of fire) expect(smoke.temperature[index]).toBeLessThan(0.3);
  simulation.dispose();
});

test('the fire stays in the picture of a phone that is held upright, wherever the head is', async () => {
  await fetchTimelineText(values);
  const simulation = new Simulation(await loadVariant('core'), scene, values, 1e6);
  const eye = new OrbitCamera(scene, values);
  eye.setSize(390, 844);
  let [farthest, seen] = [0, 0];
  for (let beat = 0; beat < 4; beat++) {
    simulation.advance(BREATH.end);
    for (let step = BREATH.end; step < BREATH.end + 40; step += 10) {
      simulation.advance(10);
      const { x, y, z, temperature } = readParticles(simulation.simulator);
      for (const index of x.keys()) {
        // Cold smoke has faded before it leaves the picture.
        if (temperature[index] < 0.1) continue;
        farthest = Math.max(farthest, Math.abs(new Vector3(x[index], y[index], z[index]).project(eye.camera).x));
        seen++;
      }
    }
    simulation.advance(BEAT - BREATH.end - 40);
  }
  simulation.dispose();
  expect(seen).toBeGreaterThan(500);
  // Puffs have a width.
  expect(farthest).toBeLessThan(0.85);
});
