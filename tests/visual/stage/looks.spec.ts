import { expect, test } from '../../support/fixtures.ts';
import { bytesOf, expectGolden } from '../../support/goldens.ts';

type Cases = typeof import('./looks.cases.ts');
const CASES = '/tests/visual/stage/looks.cases.ts';

test('six emitters have looks of their own', async ({ load }, testInfo) => {
  const cases = await load<Cases>(CASES);
  const picture = await cases.evaluateHandle((module) => module.sixLooks());
  await expectGolden(await bytesOf(picture), { name: 'six-looks', tolerance: 6, outliers: 60 }, testInfo);
});

test('states, takes and copies of a stage show its looks, and looks like the smoke draw the same pixels @long', async ({
  load,
}) => {
  const cases = await load<Cases>(CASES);
  const { recolored, ...others } = await cases.evaluate((module) => module.sameness());
  expect(others).toEqual({ sameColors: 0, restored: 0, replayed: 0, copied: 0, hasSameHash: true });
  expect(recolored).toBeGreaterThan(500);
});
