import { expect, test } from '../../support/fixtures.ts';

type Cases = typeof import('./styles.cases.ts');
const CASES = '/tests/visual/renderer/styles.cases.ts';
type Triple = readonly number[];

test('the four effects are independent: every combination has exactly its colours', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const reports = await cases.evaluate((module) => module.colorsOf());
  expect(new Set(reports.map(({ found }) => JSON.stringify(found))).size, 'different pictures').toBe(16);
  for (const { label, found, expected, slack } of reports) {
    const colors = Object.keys(found).map((key) => key.split(',').map(Number));
    const isNear = (a: Triple, b: Triple) => a.every((channel, index) => Math.abs(channel - b[index]) <= slack);
    const strange = colors.filter((color) => !expected.some((other) => isNear(color, other)));
    const missing = expected.filter((color) => !colors.some((other) => isNear(color, other)));
    expect({ strange, missing }, label).toEqual({ strange: [], missing: [] });
  }
});
