import { expect, test } from '../../../support/fixtures.ts';

type Cases = typeof import('./orbit.cases.ts');

/**
 * Pixels that motion does not explain: their colour did not occur one degree earlier within the motion of a point of
 * the smoke plus one pixel. Slivers of light, shadow and ink that appear from behind a lobe add a few such pixels at a
 * time. A puff that switches its view would change hundreds.
 */
const SPAWNED_AT_ONCE = { puff: 12, cluster: 30 };

// In the cluster the camera sees nine puffs from different sides.
for (const [what, degrees] of [
  ['cluster', 360],
  ['puff', 360],
] as const) {
  test(`the picture is continuous while the camera orbits a ${what} by ${degrees} degrees`, async ({ load }) => {
    const cases = await load<Cases>('/tests/visual/renderer/puffs/orbit.cases.ts');
    const report = await cases.evaluate((module, input) => module.orbit(...input), [what, degrees] as const);
    console.log(`orbit of a ${what}:`, report);
    expect(report.painted).toBeGreaterThan(5_000);
    expect(report.motion).toBeLessThan(2);
    expect(report.largest).toBeLessThanOrEqual(SPAWNED_AT_ONCE[what]);
  });
}
