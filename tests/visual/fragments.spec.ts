import { expect, test } from '../support/fixtures.ts';

test('the bench counts the fragments of bodies and what WebGL is given', async ({ load }) => {
  const cases = await load<typeof import('./cases/fragments.ts')>('/tests/visual/cases/fragments.ts');
  const one = await cases.evaluate((module) => module.bodies(1));
  const three = await cases.evaluate((module) => module.bodies(3));
  expect(one.rasterised).toBe(50 * 50);
  expect(one.kept).toBe(one.pixels);
  expect(one.kept).toBeGreaterThan(1000);
  expect(three).toEqual({ rasterised: 3 * one.rasterised, kept: 3 * one.kept, pixels: one.pixels });
  expect(await cases.evaluate((module) => module.uploads())).toEqual([100, 40, 32, 12]);
});
