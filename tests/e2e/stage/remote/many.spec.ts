import { longIf, test } from '../../../support/fixtures.ts';
import { expectMany } from './many.ts';

test.use({ ownPage: true });

for (const thread of ['worker', 'main'] as const) {
  // More than the browser's limit of sixteen contexts per page; the long test has forty.
  const tag = longIf(thread === 'main');
  test(`seventeen stages share a context, and only those in view play: ${thread}${tag}`, async ({ load, blank }) => {
    await expectMany({ load, blank }, [17, 3], thread);
  });
}
