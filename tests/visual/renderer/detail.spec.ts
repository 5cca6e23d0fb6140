import { expect, longIf, test } from '../../support/fixtures.ts';

type Cases = typeof import('./detail.cases.ts');
const CASES = '/tests/visual/renderer/detail.cases.ts';

for (const scene of ['train', 'wisp', 'lamp']) {
  test(`small pictures have fewer triangles, and look the same: ${scene}${longIf(scene === 'train')}`, async ({
    load,
  }) => {
    const cases = await load<Cases>(CASES);
    const { triangles, changed, pixels, after, other } = await cases.evaluate(
      (module, name) => module.pictures(name),
      scene,
    );
    const [finest, coarser] = triangles;
    expect(coarser).toBeLessThan(0.35 * finest);
    // Borders of models move by up to a quarter of a pixel, and each has a line on both sides.
    expect(changed / pixels).toBeLessThan(0.08);
    expect(changed).toBeGreaterThan(0);
    expect(after).toBe(0);
    expect(other).toBe(0);
  });
}

test('a stage draws coarser models the smaller its picture is, and the finest in large ones', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const [tiny, small, large] = await cases.evaluate((module) => module.deviations([48, 96, 720]));
  expect(large).toBe(0);
  expect(small).toBeGreaterThan(0);
  expect(tiny / small).toBeCloseTo(2, 6);
});
