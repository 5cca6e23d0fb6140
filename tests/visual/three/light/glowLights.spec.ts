import { expect, test } from '../../../support/fixtures.ts';

type Cases = typeof import('./glowLights.cases.ts');

const CASES = '/tests/visual/three/light/glowLights.cases.ts';

test('glow lights are the same for every camera, at the fire, and light the ground near it', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { lights, near, far } = await cases.evaluate((module) => module.orbiting());
  for (const other of lights.slice(1)) expect(other).toEqual(lights[0]);
  for (const [x, y, z, red, green, blue, intensity] of lights[0]) {
    expect(Math.hypot(x, z)).toBeLessThan(0.6);
    expect(y).toBeGreaterThan(0);
    expect(y).toBeLessThan(3);
    expect(red).toBe(1);
    expect(green).toBeLessThan(red);
    expect(blue).toBeLessThan(green);
    expect(intensity).toBeGreaterThan(0);
  }
  expect(near[0], JSON.stringify({ near, far })).toBeGreaterThan(120);
  expect(near[0]).toBeGreaterThan(near[2]);
  expect(far[0]).toBeLessThan(near[0] / 2);
});

test('glow lights depend on the state alone: steps at once, and a restored state, give the same', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { stepped, atOnce, restored, hashes } = await cases.evaluate((module) => module.repeated());
  expect(atOnce).toEqual(stepped);
  expect(restored).toEqual(stepped);
  expect(stepped[0][6]).toBeGreaterThan(0);
  expect(hashes[1]).toBe(hashes[0]);
});

test('glow lights follow the transform of smoke, whose scale enlarges what glows', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { plain, world, local } = await cases.evaluate((module) => module.placed());
  const [cosine, sine] = [Math.cos(0.5), Math.sin(0.5)];
  plain.forEach(([x, y, z, ...light], index) => {
    const expected = [3 + 2 * (cosine * x + sine * z), 1 + 2 * y, -2 + 2 * (cosine * z - sine * x), ...light];
    expected[6] *= 4;
    expected.forEach((number, at) => {
      expect(Math.abs(local[index][at] - number), `local ${index}: ${at}`).toBeLessThan(0.001);
      // Puffs spawn at other places: the directions across that of an emitter do not turn.
      expect(Math.abs(world[index][at] - number), `world ${index}: ${at}`).toBeLessThan(Math.max(0.3, 0.1 * number));
    });
  });
});

test('glow lights are off without glow, follow values and frames, and end with the smoke', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { withGlow, ...others } = await cases.evaluate((module) => module.life());
  expect(withGlow).toBeGreaterThan(0);
  expect(others).toEqual({ before: 0, withoutGlow: 0, cleared: 0, disposed: 0, isSame: true, moved: true });
});
