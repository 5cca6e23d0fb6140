/** The cloudscape: clouds drift with the wind and never run out, and the visible sun is in the light direction. */
import { Vector3 } from 'three';
import { expect, test } from 'vitest';
import { findPreset, presetValues } from '../../../src/parameters/presets.ts';
import { cloudscape, NOON, sunPlace, WIND } from '../../../src/scenes/cloudscape.ts';
import { lightOf, moved } from '../../../src/renderer/light.ts';
import { Simulation } from '../../../src/stage/simulation.ts';
import { readParticles } from '../../bench/support/snapshot.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

const values = presetValues(findPreset('cloudscape')!);

/** Positions of the initial puffs by seed, which is constant. */
function firstOnes(simulation: Simulation): Map<string, [x: number, y: number, z: number]> {
  const { x, y, z, size, attributes, age } = readParticles(simulation.simulator);
  const oldest = Math.max(...age) - 0.1;
  const entries = Array.from(
    x,
    (_, i) => [`${attributes[i] & 0xffff} ${size[i]}`, [x[i], y[i], z[i]], age[i]] as const,
  );
  return new Map(entries.flatMap(([key, place, seconds]) => (seconds > oldest ? [[key, [...place]]] : [])));
}

test('each puff drifts exactly by the wind times the time', async () => {
  const factory = await loadVariant('core');
  const more = -0.3;
  const still = { ...values, 'forces.turbulence': 0, 'forces.wind.x': more };
  const simulation = new Simulation(factory, cloudscape(), still, 1e6);
  simulation.advance(60);
  const before = firstOnes(simulation);
  simulation.advance(600);
  const after = firstOnes(simulation);
  expect(before.size).toBeGreaterThan(200);
  for (const [key, [x, y, z]] of before) {
    const now = after.get(key)!;
    expect(now[0] - x).toBeCloseTo(10 * (WIND + more), 3);
    expect(Math.hypot(now[1] - y, now[2] - z)).toBeLessThan(1e-4);
  }
  simulation.dispose();
});

test('new clouds replace those that have left: the meadow has as many after a minute as at the start', async () => {
  const factory = await loadVariant('core');
  const simulation = new Simulation(factory, cloudscape(), values, 1e6);
  const seen = [2, 33, 64].map((seconds) => {
    simulation.advance(60 * seconds - simulation.simulator.steps);
    return readParticles(simulation.simulator).x.filter((x) => Math.abs(x) < 6.5).length;
  });
  for (const count of seen) expect(count).toBeGreaterThan(0.6 * seen[0]);
  simulation.dispose();
});

test('the sun is on the side of the light, and moves continuously', () => {
  const { lightMove, lightCentre } = cloudscape();
  const centre = new Vector3(...lightCentre!);
  expect([values['light.azimuth'], values['light.elevation']]).toEqual([NOON.azimuth, NOON.elevation]);
  const sides = new Set<number>();
  for (let seconds = 0; seconds < 180; seconds += 0.5) {
    const light = lightOf(moved(values, lightMove!(seconds)), centre);
    if (light.kind !== 'sun') throw new Error('The preset has a lamp.');
    const [x, y] = sunPlace(seconds);
    if (Math.abs(light.towards.x) > 0.1) {
      expect(Math.sign(x - centre.x)).toBe(Math.sign(light.towards.x));
      sides.add(Math.sign(x - centre.x));
    }
    expect(y).toBeGreaterThan(centre.y + 1);
    expect(light.towards.y).toBeGreaterThan(0.5);
    const [nextX, nextY] = sunPlace(seconds + 1 / 60);
    expect(Math.hypot(nextX - x, nextY - y)).toBeLessThan(0.01);
  }
  expect(sides.size).toBe(2);
});
