/** The firework: the puffs of a shell fly apart by the closed form of their speed, drag and gravity. */
import { expect, test } from 'vitest';
import { findPreset, presetValues } from '../../../src/parameters/presets.ts';
import { fetchTimelineText } from '../../../src/renderer/extraPasses.ts';
import { firework } from '../../../src/scenes/firework.ts';
import { Simulation } from '../../../src/stage/simulation.ts';
import { readParticles } from '../../bench/support/snapshot.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

const [EMITTER, COUNT, STEP] = [1, 30, 5];
const TIMELINE = `480;burst/${STEP}*${EMITTER}*${COUNT}`;

test('a shell is a sphere that grows against drag and falls', async () => {
  const values = await fetchTimelineText({ ...presetValues(findPreset('firework')!), timeline: TIMELINE });
  const { rig } = firework();
  const simulation = new Simulation(await loadVariant('core'), firework(), values, 1e6);
  const of = (key: string) => Number(values[`emitters.${EMITTER}.${key}` as keyof typeof values] ?? rig[`emitters.${EMITTER}.${key}`]); // prettier-ignore
  const drag = rig['drag.rate'] * of('look.drag');
  const gravity = rig['gravity.acceleration'] * of('look.gravity');
  simulation.advance(STEP + 45);
  const { x, y, z, age } = readParticles(simulation.simulator);
  expect(age).toHaveLength(COUNT);
  age.forEach((seconds, i) => {
    const way = (1 - Math.exp(-drag * seconds)) / drag;
    const fallen = (gravity / drag) * (seconds - way);
    const distance = Math.hypot(x[i] - of('position.x'), y[i] - of('position.y') + fallen, z[i] - of('position.z'));
    expect(distance).toBeGreaterThan(of('speed') * (1 - of('speedVariation')) * way - of('radius') - 0.05);
    expect(distance).toBeLessThan(of('speed') * (1 + of('speedVariation')) * way + of('radius') + 0.05);
  });
  simulation.dispose();
});
