import { expect, test } from '../../support/fixtures.ts';

type Cases = typeof import('./programs.cases.ts');

for (const lobes of [10, 6]) {
  test(`all programs of a picture are compiled in advance, and none twice: puffs of ${lobes} lobes`, async ({
    load,
  }) => {
    const cases = await load<Cases>('/tests/visual/stage/programs.cases.ts');
    const { ahead, drawing } = await cases.evaluate((module, count) => module.programsOfWisp(count), lobes);
    expect(ahead.length).toBeGreaterThan(10);
    expect(new Set(ahead).size).toBe(ahead.length);
    expect(drawing).toEqual([]);
  });
}
