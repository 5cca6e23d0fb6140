import { expect, test } from '../../../../support/fixtures.ts';

type Cases = typeof import('./ballShadows.cases.ts');
type TileCases = typeof import('./volumes.cases.ts');
type LawCases = typeof import('./volumeLaw.cases.ts');
const CASES = '/tests/visual/renderer/passes/volumes/ballShadows.cases.ts';

/** reference.spec.ts compares the shadows of whole puffs. */
test('a puff of one lobe casts the shadow of a ball for any light and camera', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  for (const view of ['ordinary', 'backlit', 'besideEye', 'lamp', 'lampOrthographic'] as const) {
    const report = await cases.evaluate((module, name) => module.compare(name), view);
    expect.soft(report.receiver, view).toBeGreaterThan(20_000);
    expect.soft(report.deepest, view).toBeGreaterThan(1);
    expect.soft(report.differing / report.receiver, view).toBeLessThan(0.005);
  }
});

test('all parts of a model count as one step of shadow, and puffs as the second', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { underModel, deep, wrongColors, wrongCounts } = await cases.evaluate((module) => module.stepsUnderParts());
  expect.soft(underModel).toBeGreaterThan(500);
  expect.soft(deep).toBeGreaterThan(100);
  expect.soft(wrongCounts / underModel).toBeLessThan(0.01);
  expect.soft(wrongColors / underModel).toBeLessThan(0.01);
});

test('large volumes in tiles shade the same pixels as whole', async ({ load }) => {
  const cases = await load<TileCases>('/tests/visual/renderer/passes/volumes/volumes.cases.ts');
  for (const view of ['sun', 'lamp', 'reversedDepth'] as const) {
    const { hasTiles, shadowed, differing } = await cases.evaluate((module, name) => module.compareTiles(name), view);
    expect.soft(hasTiles, view).toBe(true);
    expect.soft(shadowed, view).toBeGreaterThan(3000);
    expect.soft(differing, view).toBe(0);
  }
});

test('the shader, TypeScript and Rust agree on shadow volumes', async ({ load }) => {
  const cases = await load<LawCases>('/tests/visual/renderer/passes/volumes/volumeLaw.cases.ts');
  const { pairs, late, small } = await cases.evaluate((module) => module.compareLaw());
  expect(pairs).toHaveLength(24);
  expect(small).toBeGreaterThan(2);
  expect(late).toBe(0);
  for (const [row, values] of pairs.entries()) {
    for (const [name, [found, expected]] of Object.entries(values))
      expect.soft(Math.abs(found - expected), `${name}, puff ${row}: ${found}, ${expected}`).toBeLessThan(2e-4);
  }
});
