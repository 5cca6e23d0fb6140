import { expect, test } from '../../../../support/fixtures.ts';

type Cases = typeof import('./meshVolumes.cases.ts');
const CASES = '/tests/visual/renderer/passes/volumes/meshVolumes.cases.ts';

test('a lamp that replaces a sun changes the shadow of a mesh at once', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { shadowed, stale } = await cases.evaluate((module) => module.staleAfterSun());
  expect(shadowed).toBeGreaterThan(200);
  expect(stale).toBe(0);
});
