/** A lamp that burns for hours: no step may go wrong, and memory must not grow. */
import { expect, it } from 'vitest';
import { defaultPreset, presetValues } from '../../src/preset/presets.ts';
import { lamp } from '../../src/scenes/lamp.ts';
import { simulatorValues } from '../../src/stage/simulatorValues.ts';
import { EVERYTHING } from '../support/everything.ts';
import { loadVariant } from './simWasm.ts';

const STEPS = 200_000;
const SAMPLES = 100;

it(`burns for ${STEPS} steps with constant memory and every particle in its place`, { timeout: 880_000 }, async () => {
  const factory = await loadVariant('physics');
  const simulator = factory.create({ capacity: 1000, seed: 11 });
  const values = presetValues(defaultPreset);
  const scene = lamp();
  simulator.set({ ...scene.rig, ...simulatorValues(values), 'emission.rate': 130 });
  for (const rigid of scene.rigids) simulator.addRigid(rigid);
  simulator.step(STEPS / SAMPLES);
  const bytes = factory.module.memory.buffer.byteLength;
  for (let sample = 1; sample < SAMPLES; ++sample) {
    simulator.moveRigid(scene.handle!.rigid, [Math.sin(sample), 1.2 + Math.sin(0.7 * sample), Math.cos(1.3 * sample)]);
    simulator.step(STEPS / SAMPLES);
    const { count, place } = simulator.arrange(EVERYTHING);
    expect(count).toBeGreaterThan(500);
    for (const value of place) expect(Math.abs(value)).toBeLessThan(50);
    expect(factory.module.memory.buffer.byteLength).toBe(bytes);
  }
  expect(simulator.steps).toBe(STEPS);
});
