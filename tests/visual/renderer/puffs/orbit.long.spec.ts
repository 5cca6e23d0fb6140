import { test } from '../../../support/fixtures.ts';
import { expectNoJump } from './orbitOf.ts';

for (const what of ['puff', 'cluster'] as const) {
  test(`the picture is continuous while the camera orbits a ${what} once, degree by degree`, async ({ load }) => {
    await expectNoJump(load, what, 360);
  });
}
