import { expect, test } from '../support/fixtures.ts';

type Cases = typeof import('./cases/stencil.ts');
const CASES = '/tests/visual/cases/stencil.ts';
type Shadows = typeof import('./cases/shadows.ts');
const SHADOWS = '/tests/visual/cases/shadows.ts';

const VIEWS = [
  ['ordinary', false],
  ['offAxis', false],
  ['eyeInside', false],
  ['backlit', false],
  ['orthographic', false],
  ['reversedDepth', false],
  ['reversedDepthOrthographic', false],
  ['lamp', false],
  ['lampAmongPuffs', false],
  ['lampOrthographic', false],
  ['ordinary', true],
  ['eyeInside', true],
  ['lamp', true],
  ['reversedDepth', true],
] as const;

for (const form of ['lobes', 'billboards'] as const) {
  for (const [view, withMesh] of VIEWS) {
    const mesh = withMesh ? ' with a mesh among them' : '';
    test(`${form}: the stencil counts volumes as a reference does: ${view}${mesh}`, async ({ load }) => {
      const cases = await load<Cases>(CASES);
      const report = await cases.evaluate((module, input) => module.compare(...input), [form, view, withMesh] as const);
      expect(report.receiver).toBeGreaterThan(20_000);
      expect(report.deepest).toBeGreaterThan(4);
      expect(report.differing / report.receiver).toBeLessThan(0.005);
      expect(report.wronglyLit / report.receiver).toBeLessThan(0.001);
    });
  }
}

for (const count of [256, 512]) {
  test(`${count} coincident casters stay dark`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const report = await cases.evaluate((module, casters) => module.coincident(casters), count);
    expect(report.shadowed).toBeGreaterThan(300);
    expect(report.lit).toBe(0);
  });
}

test('two steps of shadow show exactly three colours on the ground, by the count', async ({ load }) => {
  const cases = await load<Shadows>(SHADOWS);
  const report = await cases.evaluate((module) => module.steps(3));
  expect(report.wrong).toBe(0);
  expect(report.foreign).toEqual([]);
  expect(Math.min(report.lit, report.shadow, report.deep)).toBeGreaterThan(500);
});

for (const view of ['ordinary', 'backlit', 'lamp', 'lampOrthographic']) {
  test(`a puff of one lobe throws the shadow of a ball: ${view}`, async ({ load }) => {
    const cases = await load<Shadows>(SHADOWS);
    const report = await cases.evaluate((module, name) => module.balls(name), view);
    expect(report.receiver).toBeGreaterThan(20_000);
    expect(report.deepest).toBeGreaterThan(1);
    expect(report.differing / report.receiver).toBeLessThan(0.005);
  });
}
