import { expect } from '../../../support/fixtures.ts';
import type { LoadModule } from '../../../support/modules.ts';

type Cases = typeof import('./orbit.cases.ts');

/**
 * Pixels that motion does not explain: their colour did not occur one degree earlier within the motion of a point of
 * the smoke plus one pixel. Slivers of light, shadow and ink that appear from behind a lobe add a few such pixels at a
 * time. A puff that switches its view would change hundreds.
 */
const SPAWNED_AT_ONCE = { puff: 12, cluster: 30 };

/** Nothing jumps while the camera orbits by this number of one-degree steps. */
export async function expectNoJump(load: LoadModule, what: 'puff' | 'cluster', steps: number): Promise<void> {
  const cases = await load<Cases>('/tests/visual/renderer/puffs/orbit.cases.ts');
  const report = await cases.evaluate((module, input) => module.orbit(...input), [what, steps] as const);
  console.log(`orbit of a ${what}:`, report);
  expect(report.painted).toBeGreaterThan(5_000);
  expect(report.motion).toBeLessThan(2);
  expect(report.largest).toBeLessThanOrEqual(SPAWNED_AT_ONCE[what]);
}
