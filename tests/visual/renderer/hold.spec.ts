import { expect, test } from '../../support/fixtures.ts';

type Cases = typeof import('./hold.cases.ts');
const CASES = '/tests/visual/renderer/hold.cases.ts';

const STEPS = 30;

test('on twos, threes and fours puffs and their ink hold still, staggered, while surfaces move', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const every = Array.from({ length: STEPS }, (_, step) => step);
  const ones = await cases.evaluate((module) => module.changes(1, 1, 5));
  expect(ones).toEqual({ smoke: every.slice(0, 5), ball: every.slice(0, 5) });
  for (const hold of [2, 3, 4]) {
    const one = await cases.evaluate((module, [held, steps]) => module.changes(held, 1, steps), [hold, STEPS]);
    const length = (hold / 24) * 60;
    expect(one.ball).toEqual(every);
    expect(one.smoke, `on ${hold}s`).toHaveLength(STEPS / length);
    const waits = one.smoke.slice(1).map((step, at) => step - one.smoke[at]);
    for (const wait of waits) expect(Math.abs(wait - length)).toBeLessThan(1);
  }
  const many = await cases.evaluate((module) => module.changes(4, 12, 10));
  expect(many.smoke.length).toBeGreaterThan(4);
});
