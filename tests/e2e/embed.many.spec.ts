/** Forty stages on one page: one worker and one context for all, and only those in view draw. */
import { expect, test } from '../support/fixtures.ts';

type Cases = typeof import('./embed.cases.ts');
type ManyCases = typeof import('./embed.many.cases.ts');
const [COUNT, IN_VIEW] = [40, 12];

test.use({ ownPage: true });

for (const thread of ['worker', 'main'] as const) {
  test(`forty stages share a context, and only those in view go on: ${thread}`, async ({ load, blank }) => {
    const cases = await load<Cases>('/tests/e2e/embed.cases.ts');
    const many = await load<ManyCases>('/tests/e2e/embed.many.cases.ts');
    const contexts = await many.evaluateHandle((module) => module.countContexts());
    const opened = await many.evaluateHandle(
      (module, [count, inView, where]) => module.openMany(count, inView, where),
      [COUNT, IN_VIEW, thread] as const,
    );
    expect(await contexts.jsonValue()).toEqual({ webgl: thread === 'main' ? 1 : 0 });
    expect(blank.workers().length).toBe(thread === 'main' ? 0 : 1);
    const going = await many.evaluate((module, [list, inView]) => module.whichGoOn(list, inView), [
      opened,
      IN_VIEW,
    ] as const);
    expect(going).toEqual(Array.from({ length: COUNT }, (_, index) => index < IN_VIEW));
    const colors = await cases.evaluate(
      (module, list) => Promise.all(list.slice(0, 12).map(({ canvas }) => module.colorsShown(canvas))),
      opened,
    );
    expect(Math.min(...colors)).toBeGreaterThan(3);
    await opened.evaluate((list) => Promise.all(list.map(({ stage }) => stage.dispose())));
    await expect.poll(() => blank.workers().length).toBe(0);
  });
}
