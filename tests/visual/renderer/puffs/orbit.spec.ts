import { test } from '../../../support/fixtures.ts';
import { expectNoJump } from './orbitOf.ts';

// In the cluster the camera sees nine puffs from different sides. The long test covers the full orbit.
for (const what of ['puff', 'cluster'] as const) {
  test(`the picture is continuous while the camera orbits a ${what} by 120 degrees, degree by degree`, async ({
    load,
  }) => {
    await expectNoJump(load, what, 120);
  });
}
