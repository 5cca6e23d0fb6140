import { expect, test } from '../support/fixtures.ts';

type Cases = typeof import('./cases/creases.ts');
const CASES = '/tests/visual/cases/creases.ts';

for (const projection of ['perspective', 'orthographic'] as const) {
  test(`sharp edges have lines as wide near and far, and none through a wall: ${projection}`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    for (const distance of [2.5, 12]) {
      const report = await cases.evaluate((module, input) => module.creasesOf(...input), [
        projection,
        distance,
      ] as const);
      expect(report.expected).toBeGreaterThan(150);
      expect(report).toMatchObject({ missing: 0, stray: 0 });
    }
    const hidden = await cases.evaluate((module, input) => module.creasesOf(...input), [
      projection,
      2.5,
      true,
    ] as const);
    expect(hidden.missing).toBe(hidden.expected);
  });
}
