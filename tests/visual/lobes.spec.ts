import { expect, test } from '../support/fixtures.ts';

test('puffs of lobes are drawn as a reference on the CPU draws them', async ({ load }) => {
  const cases = await load<typeof import('./cases/lobes.ts')>('/tests/visual/cases/lobes.ts');
  const report = await cases.evaluate((module) => module.differing(12));
  console.log('lobes against the reference:', report);
  expect(report.covered).toBeGreaterThan(50_000);
  expect(report.inked).toBeGreaterThan(5_000);
  // Along borders, where single and double precision round to different sides.
  expect(report.differing / report.covered).toBeLessThan(0.003);
});

test('the form of puffs changes live, there and back', async ({ load }) => {
  const cases = await load<typeof import('./cases/lobes.ts')>('/tests/visual/cases/lobes.ts');
  const { there, back } = await cases.evaluate((module) => module.switchForms());
  expect(there).toBeGreaterThan(500);
  expect(back).toBe(0);
});
