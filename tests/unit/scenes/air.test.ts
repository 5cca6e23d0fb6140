/** Open air: no smoke enters a box of the page, and the smoke has the same size in pictures of all sizes. */
import { expect, test } from 'vitest';
import { colliderValues, curlValues } from '../../../src/page/element/layout/pageValues.ts';
import type { Values } from '../../../src/parameters/parameter.ts';
import { findPreset, presetValues } from '../../../src/parameters/presets.ts';
import { air } from '../../../src/scenes/air.ts';
import { simulatorValues } from '../../../src/simulator/simulatorValues.ts';
import { OrbitCamera } from '../../../src/stage/orbit.ts';
import { readParticles } from '../../bench/support/snapshot.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

const PLANE = { middle: [0, 0, 0], right: [0.01, 0, 0], up: [0, 0.01, 0] } as const;
const BOX = { middle: [0, 0, 0], top: [0, 0.15, 0], halfWidth: 0.4, halfHeight: 0.15 } as const;

test('smoke flows around a box above its emitter', async () => {
  const factory = await loadVariant('core');
  const simulator = factory.create({ capacity: 600, seed: 3 });
  const things = { ...colliderValues([BOX], PLANE), ...curlValues([BOX], PLANE, 0) };
  simulator.set({ ...air().rig, ...simulatorValues({ ...presetValues(findPreset('air')!), ...things }) });
  simulator.step(480);
  const { x, y } = readParticles(simulator);
  const isWithin = (_: number, index: number) =>
    Math.abs(x[index]) < BOX.halfWidth - 0.01 && Math.abs(y[index]) < BOX.halfHeight - 0.01;
  expect([...x].filter(isWithin)).toEqual([]);
  expect([...y].filter((height) => height > BOX.halfHeight).length).toBeGreaterThan(2);
  simulator.dispose();
});

/**
 * Smoke below a wide box in still air at the end of its lifetime: the share of expiring puffs within 15 mm of one line.
 */
async function alignedUnder(values: Values): Promise<number> {
  const simulator = (await loadVariant('core')).create({ capacity: 600, seed: 3 });
  const box = colliderValues([{ ...BOX, halfWidth: 3 }], PLANE);
  // So the radius is the size times the rest of the life.
  const things = { 'forces.turbulence': 0, 'emission.density': '0:1,1:0', ...box, ...values };
  simulator.set({ ...air().rig, ...simulatorValues({ ...presetValues(findPreset('air')!), ...things }) });
  simulator.step(480);
  const { y, size, age, lifetime } = readParticles(simulator);
  simulator.dispose();
  const worn = [...age.keys()].filter((index) => age[index] > 0.6 * lifetime[index]);
  const gaps = worn.map((index) => -BOX.halfHeight - y[index] - size[index] * (1 - age[index] / lifetime[index]));
  return gaps.filter((gap) => gap < 0.015).length / gaps.length;
}

test('old smoke under a rough box is lumpy, and ends in a straight line under a smooth box', async () => {
  expect(await alignedUnder({ 'colliders.0.roughness': 0 })).toBe(1);
  expect(await alignedUnder({})).toBeLessThan(0.25);
});

test.each([
  [800, 600],
  [300, 900],
  [1600, 200],
])('a metre is 150 pixels in a picture of %i by %i', (width, height) => {
  const eye = new OrbitCamera(air());
  eye.setSize(width, height);
  const metres = 2 * eye.distance * Math.tan((eye.camera.fov * Math.PI) / 360);
  expect(height / metres).toBeCloseTo(150, 3);
});
