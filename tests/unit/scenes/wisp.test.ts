/** The cup of tea: in still air each puff of steam rises by its lift, cooling and drag; wind carries it along. */
import { expect, test } from 'vitest';
import { findPreset, presetValues } from '../../../src/parameters/presets.ts';
import { wisp } from '../../../src/scenes/wisp.ts';
import { simulatorValues } from '../../../src/simulator/simulatorValues.ts';
import { readParticles } from '../../bench/support/snapshot.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

const WIND = 0.4;
/** Only the lifetimes are random, and there is no turbulence. */
const PLAIN = {
  'emitters.0.radius': 0,
  'emitters.0.speedVariation': 0,
  'emitters.0.spread': 0,
  'forces.turbulence': 0,
  'forces.vortex': 0,
  'forces.wind.x': WIND,
};

test('steam rises by the closed form and drifts by the wind times its age', async () => {
  const factory = await loadVariant('core');
  const { rig } = wisp();
  const simulator = factory.create({ capacity: 400, seed: 7 });
  simulator.set({ ...rig, ...simulatorValues(presetValues(findPreset('wisp')!)), ...PLAIN });
  simulator.step(360);
  const { x, y, age } = readParticles(simulator);
  expect(age.length).toBeGreaterThan(50);
  expect(Math.max(...age)).toBeGreaterThan(4);
  age.forEach((seconds, i) => {
    expect(x[i]).toBeCloseTo(WIND * seconds, 3);
    expect(y[i] - rig['emitters.0.position.y']).toBeCloseTo(height(rig, seconds), 2);
  });
  simulator.dispose();
});

/** Height gained by steam, metres: slip v with v' = lift exp(-t / cooling) - drag v, from the emitter's speed on. */
function height(rig: Readonly<Record<string, number>>, t: number): number {
  const [drag, cooling] = [rig['drag.rate'], rig['buoyancy.coolingTime']];
  const braked = (1 - Math.exp(-drag * t)) / drag;
  const cooled = cooling * (1 - Math.exp(-t / cooling));
  return rig['emitters.0.speed'] * braked + (rig['buoyancy.acceleration'] / (drag - 1 / cooling)) * (cooled - braked);
}
