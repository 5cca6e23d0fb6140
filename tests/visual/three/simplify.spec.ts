import { expect, test } from '../../support/fixtures.ts';

type Cases = typeof import('./simplify.cases.ts');
const CASES = '/tests/visual/three/simplify.cases.ts';

for (const [steps, values] of [
  [1, { 'style.simplify': 3 }],
  [2, { 'style.simplify': 3 }],
  [1, { 'style.form': 0.7 }],
] as const) {
  test(`light is simplified on smoke alone: ${JSON.stringify(values)}, ${steps} steps of shadow`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const change = await cases.evaluate((module, [given, count]) => module.changedBy(given, count), [
      values,
      steps,
    ] as const);
    const [before, after] = change.border;
    console.log(JSON.stringify(change));
    expect(change.beside).toBe(0);
    expect(change.inside).toBeGreaterThan(2000);
    expect(before).toBeGreaterThan(200);
  });
}
