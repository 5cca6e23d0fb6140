import { expect, test } from '../support/fixtures.ts';

type Cases = typeof import('./cases/ballShadows.ts');
const CASES = '/tests/visual/cases/ballShadows.ts';

/** Shadows of whole puffs are compared in reference.spec.ts. */
test('a puff of one lobe throws the shadow of a ball, wherever the light and the eye stand', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  for (const view of ['ordinary', 'backlit', 'besideEye', 'lamp', 'lampOrthographic'] as const) {
    const report = await cases.evaluate((module, name) => module.compare(name), view);
    expect.soft(report.receiver, view).toBeGreaterThan(20_000);
    expect.soft(report.deepest, view).toBeGreaterThan(1);
    expect.soft(report.differing / report.receiver, view).toBeLessThan(0.005);
  }
});
