/** The campfire: smoke cools by its formula, and its colour follows its temperature. */
import { expect, test } from 'vitest';
import { findPreset, presetValues } from '../../../src/parameters/presets.ts';
import { campfire } from '../../../src/scenes/campfire.ts';
import { bandsOf } from '../../../src/renderer/palette.ts';
import { styleOf } from '../../../src/renderer/style.ts';
import { Simulation } from '../../../src/stage/simulation.ts';
import { readParticles } from '../../bench/support/snapshot.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

const values = presetValues(findPreset('campfire')!);
/** Colours of the temperature bands, each with its lower bound. */
const { heatColors } = styleOf(values);

test('flames and sparks cool exponentially and are colder the higher they are', async () => {
  const factory = await loadVariant('core');
  const scene = campfire();
  const simulation = new Simulation(factory, scene, values, 1e6);
  simulation.advance(420);
  const { age, temperature, y } = readParticles(simulation.simulator);
  const births = [scene.rig['emitters.0.temperature'], scene.rig['emitters.1.temperature']];
  const cooling = scene.rig['buoyancy.coolingTime'];
  const seen = new Set<number>();
  temperature.forEach((warm, i) => {
    const spawned = warm * Math.exp(age[i] / cooling);
    const source = births.findIndex((at) => Math.abs(spawned - at) < 0.02 * at);
    expect(source).toBeGreaterThanOrEqual(0);
    seen.add(source);
  });
  expect(seen).toEqual(new Set([0, 1]));
  const mean = (low: number, high: number): number => {
    const flames = [...temperature].filter((warm, i) => warm <= 1 && y[i] >= low && y[i] < high);
    expect(flames.length).toBeGreaterThan(10);
    return flames.reduce((sum, warm) => sum + warm, 0) / flames.length;
  };
  const heights = [[0, 0.6], [0.6, 1.2], [1.2, 2], [2, 4]].map(([low, high]) => mean(low, high)); // prettier-ignore
  expect(heights).toEqual(heights.toSorted((a, b) => b - a));
  simulation.dispose();
});

test('colours darken gradually from fire to smoke as puffs cool', () => {
  const luma = ([red, green, blue]: readonly number[]) => 0.2126 * red + 0.7152 * green + 0.0722 * blue;
  const steps = heatColors.map(({ color }) => luma(color));
  expect(steps.length).toBeGreaterThan(4);
  expect(steps).toEqual(steps.toSorted((a, b) => a - b));
  expect(new Set(steps).size).toBe(steps.length);
  // Red exceeds blue by far in fire, but not in smoke.
  const warmth = heatColors.map(({ color: [red, , blue] }) => red - blue);
  expect(warmth[0]).toBeLessThan(0);
  expect(Math.max(...warmth)).toBeGreaterThan(150);
  const { colors } = bandsOf(styleOf(values), 0);
  expect([colors[0], colors.at(-1)]).toEqual([heatColors[0].color, heatColors.at(-1)!.color]);
  const drawn = colors.map(luma);
  // Channels are integers.
  for (const [i, one] of drawn.slice(1).entries()) expect(one).toBeGreaterThan(drawn[i] - 1);
  const jumps = colors
    .slice(1)
    .map((color, i) => Math.max(...color.map((channel, at) => Math.abs(channel - colors[i][at]))));
  expect(Math.max(...jumps)).toBeLessThan(24);
});
