/** Many stages on one page: one worker and one context for all, and only those in view draw. */
import type { Page } from '@playwright/test';
import { expect } from '../../../support/fixtures.ts';
import type { LoadModule } from '../../../support/modules.ts';
import { setTimeouts, changeContext } from './context.ts';

type ProvokedCases = typeof import('../../page/element/provoked.cases.ts');
type Cases = typeof import('./stage.cases.ts');
type ManyCases = typeof import('./many.cases.ts');

/** @param blank a separate page */
export async function expectMany(
  { load, blank }: { load: LoadModule; blank: Page },
  [count, inView]: readonly [count: number, inView: number],
  thread: 'main' | 'worker',
): Promise<void> {
  const cases = await load<Cases>('/tests/e2e/stage/remote/stage.cases.ts');
  const many = await load<ManyCases>('/tests/e2e/stage/remote/many.cases.ts');
  const contexts = await many.evaluateHandle((module) => module.countContexts());
  const opened = await many.evaluateHandle((module, given) => module.openMany(...given), [
    count,
    inView,
    thread,
  ] as const);
  expect(await contexts.jsonValue()).toEqual({ webgl: thread === 'main' ? 1 : 0 });
  expect(blank.workers().length).toBe(thread === 'main' ? 0 : 1);
  const going = await many.evaluate((module, [list, seen]) => module.whichGoOn(list, seen), [opened, inView] as const);
  expect(going).toEqual(Array.from({ length: count }, (_, index) => index < inView));
  const colors = await cases.evaluate(
    (module, [list, seen]) => Promise.all(list.slice(0, seen).map(({ canvas }) => module.colorsShown(canvas, 3))),
    [opened, inView] as const,
  );
  expect(Math.min(...colors)).toBeGreaterThan(3);
  await opened.evaluate((list) => Promise.all(list.map(({ stage }) => stage.dispose())));
  await expect.poll(() => blank.workers().length).toBe(0);
}

/** Elements whose context is lost and restored twice: all of them continue to draw without an event. */
export async function expectBack(
  { load, blank }: { load: LoadModule; blank: Page },
  count: number,
  thread: 'main' | 'worker',
): Promise<void> {
  const cases = await load<ProvokedCases>('/tests/e2e/page/element/provoked.cases.ts');
  const shown = await cases.evaluateHandle((module, given) => module.showSome(...given), [count, thread] as const);
  const notified = () => shown.evaluate((all) => all.map((one) => one.notified.join()));
  await shown.evaluate((all) => Promise.all(all.map(({ element }) => element.ready)));
  const drawing = thread === 'main' ? blank : blank.workers()[0];
  await setTimeouts(drawing, 'endless');
  for (let loss = 0; loss < 2; ++loss) {
    await changeContext(drawing, 'loseContext');
    await changeContext(drawing, 'restoreContext');
  }
  await cases.evaluate((module, all) => module.allDraw(all), shown);
  expect(await notified()).toEqual(Array(count).fill(`ready on ${thread}`));
}
