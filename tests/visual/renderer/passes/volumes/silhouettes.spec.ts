import { expect, longIf, test } from '../../../../support/fixtures.ts';

type Cases = typeof import('./silhouettes.cases.ts');
const CASES = '/tests/visual/renderer/passes/volumes/silhouettes.cases.ts';

const NAMES = ['heartCard', 'letterO', 'leaf'] as const;

for (const [what, light, trials, options, isLong] of [
  ['a sun', 'sun', 200, {}, true],
  ['a sun, few', 'sun', 48, {}, false],
  ['a lamp', 'lamp', 200, {}, true],
  ['a lamp, few', 'lamp', 24, {}, false],
  ['a sun, from eight sides', 'sun', 48, { sides: 8 }, true],
] as const) {
  test(`the shadow of a card on a wall is its silhouette: ${what}${longIf(isLong)}`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const report = await cases.evaluate((module, given) => module.compareShadows(...given), [
      NAMES,
      light,
      trials,
      options,
    ] as const);
    process.stdout.write(`${JSON.stringify(report)}\n`);
    expect(report.layers).toBe('sides' in options ? 24 : 3);
    expect(report.expected).toBeGreaterThan(4000 * trials);
    expect(report.backlit).toBeGreaterThan(trials / 5);
    expect(report.differing / report.expected).toBeLessThan(0.0015);
    expect(report.worst).toBeLessThan(0.03);
  });
}
