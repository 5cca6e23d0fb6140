import { expect, test } from '../support/fixtures.ts';

type Cases = typeof import('./cases/orbit.ts');
const CASES = '/tests/visual/cases/orbit.ts';

/**
 * What motion does not explain: a colour that a pixel takes on though a degree ago it stood nowhere within the way that
 * a point of the smoke moves, and one pixel. Slivers of light, shadow and ink that come up from behind a lobe are born
 * so, a few pixels at a time; a puff that switched its view would change hundreds.
 */
const BORN_AT_ONCE = { puff: 12, cluster: 30 };

for (const what of ['puff', 'cluster'] as const) {
  test(`nothing jumps while the camera goes round a ${what} in steps of a degree`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const report = await cases.evaluate((module, name) => module.orbit(name), what);
    console.log(`orbit of a ${what}:`, report);
    expect(report.painted).toBeGreaterThan(5_000);
    expect(report.motion).toBeLessThan(2);
    expect(report.largest).toBeLessThanOrEqual(BORN_AT_ONCE[what]);
  });
}
