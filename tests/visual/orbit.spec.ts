import { test } from '../support/fixtures.ts';
import { expectNoJump } from './orbitOf.ts';

// In the cluster nine puffs are seen from as many sides; the long test goes all the way round.
for (const what of ['puff', 'cluster'] as const) {
  test(`nothing jumps while the camera goes a third of the way round a ${what}, degree by degree`, async ({ load }) => {
    await expectNoJump(load, what, 120);
  });
}
