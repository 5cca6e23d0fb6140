import { expect, test } from '../../../support/fixtures.ts';

type Cases = typeof import('./rareForces.cases.ts');
const CASES = '/tests/visual/three/state/rareForces.cases.ts';

test.use({ ownPage: true });

test('smoke waits for the simulator with flows, and has the hash of smoke that did not', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { steps, flows, lanes } = await cases.evaluate((module) => module.hashes());
  expect(steps).toEqual([20, 120]);
  expect(new Set(flows).size).toBe(1);
  expect(new Set(lanes).size).toBe(1);
});

test('a flow rides on an object; physics: false forbids flows', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { heights, errors } = await cases.evaluate((module) => module.riding());
  expect(heights[1]).toBeGreaterThan(heights[0] + 0.5);
  expect(errors).toEqual(['UnsupportedError', 'UnsupportedError', 'false']);
});
