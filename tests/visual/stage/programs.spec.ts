import { expect, test } from '../../support/fixtures.ts';

type Cases = typeof import('./programs.cases.ts');

for (const lobes of [10, 6]) {
  test(`the two largest programs are compiled in advance, and none twice: puffs of ${lobes} lobes`, async ({
    load,
  }) => {
    const cases = await load<Cases>('/tests/visual/stage/programs.cases.ts');
    const { ahead, drawing } = await cases.evaluate((module, count) => module.programsOfWisp(count), lobes);
    const all = [...ahead, ...drawing];
    expect(new Set(all).size).toBe(all.length);
    const largest = all.toSorted((one, other) => other.length - one.length).slice(0, 2);
    expect(ahead).toEqual(expect.arrayContaining(largest));
    expect(drawing.length).toBeGreaterThan(2);
  });
}
