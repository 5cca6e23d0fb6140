import { expect, longIf, test } from '../../../support/fixtures.ts';

type Cases = typeof import('./surfaceDepth.cases.ts');
const CASES = '/tests/visual/renderer/passes/surfaceDepth.cases.ts';

for (const form of ['lobes', 'billboards'] as const) {
  test(`${form}: the outline of a puff on a floor is closed${longIf(form === 'billboards')}`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    for (const { name, fill, ink, leaked, connected } of await cases.evaluate(
      (module, shape) => module.onFloor(shape),
      form,
    )) {
      expect(fill, name).toBeGreaterThan(1_000);
      expect(leaked, name).toBe(0);
      expect(connected / ink, name).toBeGreaterThan(0.97);
    }
  });

  test(`${form}: a puff behind a wall shows no line through it, before it all of its line`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    for (const gap of [0, 0.05, 0.4]) {
      const behind = await cases.evaluate((module, input) => module.atWall(...input), [form, 'behind', gap] as const);
      expect(behind.onWall, `${gap} m`).toBe(0);
      expect(behind.ink).toBeGreaterThan(100);
      const before = await cases.evaluate((module, input) => module.atWall(...input), [form, 'before', gap] as const);
      expect(before.onWall / before.ink, `${gap} m`).toBeGreaterThan(0.35);
    }
  });
}
