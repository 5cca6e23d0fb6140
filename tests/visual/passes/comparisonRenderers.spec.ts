import { expect, test } from '../../support/fixtures.ts';

type Cases = typeof import('./comparisonRenderers.cases.ts');
const CASES = '/tests/visual/passes/comparisonRenderers.cases.ts';
type Shadows = typeof import('./ballShadows.cases.ts');
const SHADOWS = '/tests/visual/passes/ballShadows.cases.ts';

test('selle draws closed lines one pixel wide exactly where the depth gap is over the threshold, and three flat colours', async ({
  load,
}) => {
  const cases = await load<Cases>(CASES);
  const [under, over] = await cases.evaluate((module) => [module.depthLines(0.9), module.depthLines(1.1)]);
  for (const { missing, extra, thickest, isClosed } of [under, over]) {
    expect({ missing, extra, thickest, isClosed }).toEqual({ missing: 0, extra: 0, thickest: 1, isClosed: true });
  }
  // The line is around the larger puff. With the larger gap there is also a line around the smaller one in front of it.
  expect(under.line).toBeGreaterThan(90);
  expect(over.line - under.line).toBeGreaterThan(20);
  // Page, fully lit smoke, ink.
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

/** Share of a shadow's area that the texels of the shadow map may remove or add. */
const MAX_OF_SHADOW = 0.015;

for (const view of ['sun', 'distantLamp', 'lampAbove', 'lampAmongCrates', 'lampBelow'] as const) {
  test(`the shadow map darkens exactly the ground in shadow: ${view}`, async ({ load }) => {
    const cases = await load<Shadows>(SHADOWS);
    const { shadow, missing, extra } = await cases.evaluate((module, name) => module.mapErrors(name), view);
    expect(shadow).toBeGreaterThan(1_000);
    expect(missing / shadow).toBeLessThan(MAX_OF_SHADOW);
    expect(extra / shadow).toBeLessThan(MAX_OF_SHADOW);
  });
}
