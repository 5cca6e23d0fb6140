import { test } from '../../support/fixtures.ts';
import { expectNoJump } from './orbitOf.ts';

for (const what of ['puff', 'cluster'] as const) {
  test(`nothing jumps while the camera goes all the way round a ${what}, degree by degree`, async ({ load }) => {
    await expectNoJump(load, what, 360);
  });
}
