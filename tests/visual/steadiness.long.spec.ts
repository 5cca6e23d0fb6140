import { expect, test } from '../support/fixtures.ts';

type Cases = typeof import('./cases/steadiness.ts');
const CASES = '/tests/visual/cases/steadiness.ts';

/**
 * Pixels of an area that may come or go at once: slivers of light, shadow and ink from behind a lobe are born so. A puff
 * of the lamp covers about 300.
 */
const SLIVER = 12;

test('nothing pops in the lamp during ten seconds', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const report = await cases.evaluate((module) => module.timePassing('lamp', 30, 600));
  console.log('lamp, ten seconds:', report);
  expect(report.bodies).toBeGreaterThan(0);
  expect(report.largest).toBeLessThanOrEqual(SLIVER);
});

test('nothing jumps in the lamp while the camera goes all the way round', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const report = await cases.evaluate((module) => module.orbiting('lamp', 240, 360));
  console.log('lamp, 360 degrees:', report);
  expect(report.bodies).toBeGreaterThan(0);
  expect(report.largest).toBeLessThanOrEqual(SLIVER);
});
