import { expect, test } from '../../../support/fixtures.ts';

type Cases = typeof import('./ink.cases.ts');
const CASES = '/tests/visual/renderer/passes/ink.cases.ts';

/** Pixels: billboards sample their distance from a texture, lobes compute it. */
const SLACK = { lobes: 0.1, billboards: 1 };

for (const form of ['lobes', 'billboards'] as const) {
  for (const projection of ['perspective', 'orthographic'] as const) {
    test(`${form}: a line has the same width in CSS pixels near and far: ${projection}`, async ({ load }) => {
      const cases = await load<Cases>(CASES);
      const lines = [1, 2, 3].flatMap((pixelRatio) =>
        [2, 3.5, 5].map((distance) => ({ form, projection, distance, pixelRatio, outlineWidth: 1.5 })),
      );
      const reports = await cases.evaluate((module, input) => module.measureLines(input), lines);
      reports.forEach(({ worst, ink, expectedWidth }, index) => {
        expect(expectedWidth).toBe(1.5 * lines[index].pixelRatio);
        expect(ink).toBeGreaterThan(150);
        expect(worst, JSON.stringify(lines[index])).toBeLessThan(SLACK[form]);
      });
    });
  }

  test(`${form}: a line narrows and fades beside small puffs until it ends`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const lines = [1, 2].flatMap((pixelRatio) =>
      [9, 12, 15, 40, 70].map((distance) => ({
        form,
        projection: 'perspective' as const,
        distance,
        pixelRatio,
        outlineWidth: 4 / pixelRatio,
      })),
    );
    const reports = await cases.evaluate((module, input) => module.measureLines(input), lines);
    expect(reports.filter(({ expectedWidth }) => expectedWidth > 1 && expectedWidth < 4)).toHaveLength(4);
    expect(reports.filter(({ expectedShare }) => expectedShare > 0.1 && expectedShare < 0.9)).toHaveLength(2);
    for (const { worst, ink, expectedWidth, expectedShare, share, radius } of reports) {
      if (expectedShare > 0.5) expect(worst, `radius ${radius}`).toBeLessThan(SLACK[form]);
      if (expectedWidth < 0.4) expect(ink, `radius ${radius}`).toBe(0);
      expect(share, `radius ${radius}`).toBeCloseTo(expectedShare, 2);
    }
  });

  test(`${form}: line swell and boil follow their formulas`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const line = { form, projection: 'perspective', distance: 2, pixelRatio: 1, outlineWidth: 4 } as const;
    const [even, swollen, boiling] = await cases.evaluate(
      (module, input) => module.measureLines([input, { ...input, inkSwell: 1 }, { ...input, boil: 1 }]),
      line,
    );
    expect(Math.max(even.worst, swollen.worst, boiling.worst)).toBeLessThan(SLACK[form]);
    expect(boiling.ink).toBeLessThan(0.9 * even.ink);
    expect(swollen.expectedWidth).toBeCloseTo(4);
  });

  test(`${form}: a boiling line moves between drawings and not within one`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const { between, within, beyond, ink } = await cases.evaluate((module, shape) => module.boiling(shape), form);
    expect(ink).toBeGreaterThan(400);
    expect(between).toBeGreaterThan(60);
    expect(between).toBeLessThan(ink);
    expect([within, beyond]).toEqual([0, 0]);
  });

  test(`${form}: a far plume keeps the colour of smoke`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const { covered, dark } = await cases.evaluate((module, shape) => module.farPlume(shape), form);
    expect(covered).toBeGreaterThan(1_500);
    expect(dark / covered).toBeLessThan(0.02);
  });
}
