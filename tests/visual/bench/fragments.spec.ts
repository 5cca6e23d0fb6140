import { expect, longIf, test } from '../../support/fixtures.ts';

for (const form of ['lobes', 'billboards'] as const) {
  test(`the bench counts the fragments of bodies: ${form}${longIf(form === 'lobes')}`, async ({ load }) => {
    const cases = await load<typeof import('./fragments.cases.ts')>('/tests/visual/bench/fragments.cases.ts');
    const one = await cases.evaluate((module, shape) => module.bodies(shape, 1), form);
    const three = await cases.evaluate((module, shape) => module.bodies(shape, 3), form);
    expect(one.rasterised).toBe(await cases.evaluate((module, shape) => module.quadPixels(shape), form));
    expect(one.kept).toBe(one.pixels);
    expect(one.kept).toBeGreaterThan(1000);
    expect(three).toEqual({ rasterised: 3 * one.rasterised, kept: 3 * one.kept, pixels: one.pixels });
  });
}

test('the bench counts the WebGL calls', async ({ load }) => {
  const cases = await load<typeof import('./fragments.cases.ts')>('/tests/visual/bench/fragments.cases.ts');
  expect(await cases.evaluate((module) => module.uploads())).toEqual([100, 40, 32, 12, 96]);
});
