import { expect, test } from '../../support/fixtures.ts';

type Cases = typeof import('./steadiness.cases.ts');
const CASES = '/tests/visual/renderer/steadiness.cases.ts';

/**
 * Pixels of an area that may appear or vanish at once: slivers of light, shadow and ink from behind a lobe do. A puff
 * of the lamp covers about 300.
 */
const SLIVER = 12;

test('no puff pops in the lamp during a quarter of a second', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const report = await cases.evaluate((module) => module.timePassing('lamp', 240, 15));
  console.log('lamp, a quarter of a second:', report);
  expect(report.bodies).toBeGreaterThan(50);
  expect(report.smoke).toBeGreaterThan(3_000);
  expect(report.largest).toBeLessThanOrEqual(SLIVER);
});

test('the picture of the lamp is continuous while the camera orbits by 20 degrees', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const report = await cases.evaluate((module) => module.orbiting('lamp', 240, 20));
  console.log('lamp, 20 degrees:', report);
  expect(report.bodies).toBeGreaterThan(50);
  expect(report.smoke).toBeGreaterThan(3_000);
  expect(report.largest).toBeLessThanOrEqual(SLIVER);
});
