import { test } from '../../support/fixtures.ts';
import { expectStatesReturn } from './states.ts';

test.use({ viewport: { width: 120, height: 90 } });

test('four random states survive a round trip from the address to the stage @long', async ({ page }) => {
  await expectStatesReturn(page, 4, 4);
});
