import { expect, test } from '../support/fixtures.ts';

type Cases = typeof import('./cases/rivals.ts');
const CASES = '/tests/visual/cases/rivals.ts';

test('selle draws lines one pixel wide where the depth gap is over the threshold, and three flat colours', async ({
  load,
}) => {
  const cases = await load<Cases>(CASES);
  const [under, over] = await cases.evaluate((module) => [module.depthLines(0.9), module.depthLines(1.1)]);
  expect(under.ink).toBe(0);
  expect(over.ink).toBeGreaterThan(60);
  expect(over.thickest).toBeLessThanOrEqual(2);
  // The page, smoke in full light, ink.
  expect(over.colors).toBe(3);
});

test('sprites blend one over the other', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { drawn, expected } = await cases.evaluate((module) => module.blendedSprites());
  drawn.forEach((value, channel) => expect(Math.abs(value - expected[channel])).toBeLessThanOrEqual(2));
});

test('sprites fade towards a surface behind them', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const [near, half, far] = await cases.evaluate((module) => [0.1, 0.5, 1.5].map(module.softness));
  expect(near).toBeCloseTo(0.1, 1);
  expect(half).toBeCloseTo(0.5, 1);
  expect(far).toBeCloseTo(1, 1);
});

test('the shadow map darkens ground only within the volumes, which reach a little farther', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { volumes, map, both } = await cases.evaluate((module) => module.shadowsCompared());
  expect(volumes).toBeGreaterThan(1_000);
  expect(both / map).toBeGreaterThan(0.98);
  expect(both / volumes).toBeGreaterThan(0.7);
});
