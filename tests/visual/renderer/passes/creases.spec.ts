import { expect, test } from '../../../support/fixtures.ts';

type Cases = typeof import('./creases.cases.ts');
const CASES = '/tests/visual/renderer/passes/creases.cases.ts';

for (const reversedDepth of [false, true]) {
  for (const projection of ['perspective', 'orthographic'] as const) {
    const reversed = reversedDepth ? ', depth reversed' : '';
    test(`lines along sharp edges and seams have the same width near and far, and walls hide them: ${projection}${reversed}`, async ({
      load,
    }) => {
      const cases = await load<Cases>(CASES);
      const view = { projection, reversedDepth };
      for (const distance of [2.5, 12]) {
        const report = await cases.evaluate((module, input) => module.creasesOf(input), { ...view, distance });
        expect(report.expected).toBeGreaterThan(150);
        expect(report).toMatchObject({ missing: 0, stray: 0 });
      }
      for (const sunk of [0, 0.15]) {
        const report = await cases.evaluate((module, input) => module.creasesOf(input), {
          ...view,
          distance: 2.5,
          sunk,
        });
        expect(report.expected).toBeGreaterThan(150);
        expect(report, `${sunk} m deep in a floor`).toMatchObject({ missing: 0, stray: 0 });
      }
      const walled = { ...view, distance: 2.5, behind: true };
      const hidden = await cases.evaluate((module, input) => module.creasesOf(input), walled);
      expect(hidden.missing).toBe(hidden.expected);
    });
  }
}
