import { expect, test } from '../../../support/fixtures.ts';

test('the form of puffs can be changed while playing', async ({ load }) => {
  const cases = await load<typeof import('./lobes.cases.ts')>('/tests/visual/renderer/puffs/lobes.cases.ts');
  const { there, back } = await cases.evaluate((module) => module.switchForms());
  expect(there).toBeGreaterThan(500);
  expect(back).toBe(0);
});
