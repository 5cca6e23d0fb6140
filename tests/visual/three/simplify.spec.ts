import { expect, longIf, test } from '../../support/fixtures.ts';

type Cases = typeof import('./simplify.cases.ts');
const CASES = '/tests/visual/three/simplify.cases.ts';

for (const steps of [1, 2] as const) {
  test(`light is simplified on smoke alone, with ${steps} steps of shadow${longIf(steps > 1)}`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const { beside, inside, changed, border } = await cases.evaluate(
      (module, count) => module.changedBy({ 'style.simplify': 3 }, count),
      steps,
    );
    expect(beside).toBe(0);
    expect(inside).toBeGreaterThan(2000);
    expect(border[0]).toBeGreaterThan(400);
    expect(border[1] / border[0]).toBeLessThan(0.75);
    // The shadow of the ball stays.
    expect(changed / inside).toBeGreaterThan(0.1);
    expect(changed / inside).toBeLessThan(0.3);
  });
}

test('light follows the form of the whole smoke on smoke alone', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { beside, inside, changed } = await cases.evaluate((module) => module.changedBy({ 'style.form': 0.7 }, 1));
  expect(beside).toBe(0);
  expect(changed / inside).toBeGreaterThan(0.1);
});

test('targets without stencil, mirrors and moved scenes show the same simplified light @long', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { composed, mirrored, moved } = await cases.evaluate((module) => module.elsewhere());
  expect(composed.errors).toEqual([]);
  expect(composed.difference - composed.bare).toBeLessThan(0.0005);
  expect(mirrored.smoke).toBeGreaterThan(500);
  expect(mirrored.difference).toBeLessThan(0.0002);
  for (const { distinct } of [composed, mirrored]) expect(distinct).toBeLessThan(44);
  expect(moved.without).toBeGreaterThan(2000);
  expect(moved.moved).toBeLessThan(10);
});
