import { expect, test } from '../../support/fixtures.ts';

type Tools = typeof import('./tools.cases.ts');
const TOOLS = '/tests/visual/three/tools.cases.ts';

test('exporters and tools that walk a scene find an empty group in place of smoke', async ({ load }) => {
  const cases = await load<Tools>(TOOLS);
  const { different, drawn } = await cases.evaluate((module) => module.found());
  expect(different).toEqual([]);
  expect(drawn).toBeGreaterThan(1000);
});

test('the state of the smoke object has the effect that it has on other objects', async ({ load }) => {
  const cases = await load<Tools>(TOOLS);
  expect(await cases.evaluate((module) => module.states())).toEqual([]);
});

test('the callbacks of the smoke object are called when it is drawn', async ({ load }) => {
  const cases = await load<Tools>(TOOLS);
  const [before, after, drawn] = await cases.evaluate((module) => module.callbacks());
  expect([before, after]).toEqual([1, 1]);
  expect(drawn).toBeGreaterThan(1000);
});

test('a view that shows nothing is no error, and smoke is back after it', async ({ load }) => {
  const cases = await load<Tools>(TOOLS);
  expect(await cases.evaluate((module) => module.emptyViews())).toEqual([]);
});
