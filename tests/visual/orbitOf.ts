import { expect } from '../support/fixtures.ts';
import type { LoadModule } from '../support/modules.ts';

type Cases = typeof import('./cases/orbit.ts');

/**
 * What motion does not explain: a colour that a pixel takes on though a degree ago it stood nowhere within the way that
 * a point of the smoke moves, and one pixel. Slivers of light, shadow and ink that come up from behind a lobe are born
 * so, a few pixels at a time; a puff that switched its view would change hundreds.
 */
const SPAWNED_AT_ONCE = { puff: 12, cluster: 30 };

/** Nothing jumps while the camera goes round by so many steps of a degree. */
export async function expectNoJump(load: LoadModule, what: 'puff' | 'cluster', steps: number): Promise<void> {
  const cases = await load<Cases>('/tests/visual/cases/orbit.ts');
  const report = await cases.evaluate((module, input) => module.orbit(...input), [what, steps] as const);
  console.log(`orbit of a ${what}:`, report);
  expect(report.painted).toBeGreaterThan(5_000);
  expect(report.motion).toBeLessThan(2);
  expect(report.largest).toBeLessThanOrEqual(SPAWNED_AT_ONCE[what]);
}
