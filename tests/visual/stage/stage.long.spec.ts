/** Long tests of stages; stage.spec.ts has shorter versions. */
import { test } from '../../support/fixtures.ts';
import { expectGone } from './ends.ts';

test.use({ allowed: /context lost|context restored|CONTEXT_LOST/i, ownPage: true });

test('40 stages leave no live context and no object', async ({ load, blank }) => {
  await expectGone(load, blank, 40);
});
