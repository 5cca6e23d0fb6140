/** Faults that no page can bring about, and contexts that go, seen through the element: it recovers or gives up, and says so. */
import type { JSHandle } from '@playwright/test';
import { expect, test } from '../support/fixtures.ts';
import type { LoadModule } from '../support/modules.ts';
import type { Shown } from './embed.provoked.cases.ts';
import { turnContext } from './embed.context.ts';

type Cases = typeof import('./embed.provoked.cases.ts');
type Shared = typeof import('../../src/remote/sharedDevice.ts');
const CASES = '/tests/e2e/embed.provoked.cases.ts';

test.use({ ownPage: true, allowed: /context lost|context restored|CONTEXT_LOST/i });

async function expectGivenUp(load: LoadModule, shown: JSHandle<Shown>, told: string[]): Promise<void> {
  const cases = await load<Cases>(CASES);
  await expect.poll(() => shown.evaluate((one) => one.told)).toEqual(told);
  expect(await cases.evaluate((module, one) => module.isGivenUp(one), shown)).toBe(true);
}

for (const thread of ['main', 'worker'] as const) {
  test(`a simulator without memory leaves the poster and tells a SimulatorError: ${thread}`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const shown = await cases.evaluateHandle((module, where) => module.show(where, { fault: 'outOfMemory' }), thread);
    await expectGivenUp(load, shown, ['SimulatorError']);
  });
}

test('a context that goes and comes goes on with its smoke, until it goes too often', async ({ load, blank }) => {
  const cases = await load<Cases>(CASES);
  const shown = await cases.evaluateHandle((module) => module.show('main'));
  await expect.poll(() => shown.evaluate(({ told }) => told)).toEqual(['ready on main']);
  for (let loss = 0; loss < 3; ++loss) {
    await turnContext(blank, 'loseContext');
    await turnContext(blank, 'restoreContext');
  }
  await expect.poll(() => cases.evaluate((module, one) => module.colorsOf(one), shown)).toBeGreaterThan(3);
  expect(await shown.evaluate(({ told }) => told)).toEqual(['ready on main']);
  await turnContext(blank, 'loseContext');
  await expectGivenUp(load, shown, ['ready on main', 'ContextError']);
});

test('a context that is lost in the start and stays away is waited for, then given up', async ({ load, blank }) => {
  await blank.clock.install();
  const cases = await load<Cases>(CASES);
  const shared = await load<Shared>('/src/remote/sharedDevice.ts');
  const shown = await cases.evaluateHandle((module) => module.show('main', { fault: 'contextLostInStart' }));
  await expect.poll(() => shared.evaluate(({ threadDevice }) => threadDevice.hold()!.isUsable)).toBe(false);
  // It may stand blank before it is given up.
  await expect
    .poll(async () => {
      await blank.clock.fastForward(10_000);
      return shown.evaluate(({ told }) => told.at(-1));
    })
    .toBe('ContextError');
  expect(await cases.evaluate((module, one) => module.isGivenUp(one), shown)).toBe(true);
});

test('a worker that ends without a word in the start is noticed, and the next smoke goes without it', async ({
  load,
  blank,
}) => {
  await blank.clock.install();
  const cases = await load<Cases>(CASES);
  const shown = await cases.evaluateHandle((module) => module.show('worker', { fault: 'workerSilent' }));
  await expect.poll(() => blank.workers().length).toBe(1);
  await expect.poll(() => shown.evaluate(({ element }) => element.shadowRoot!.querySelector('canvas'))).not.toBeNull();
  const beats = async (count: number) => {
    for (let beat = 0; beat < count; ++beat) await blank.clock.fastForward(10_000);
  };
  await beats(5);
  expect(await shown.evaluate(({ told }) => told)).toEqual([]);
  await beats(8);
  await expectGivenUp(load, shown, ['SimulatorError']);
  const next = await cases.evaluateHandle((module) => module.show('auto'));
  await expect.poll(() => next.evaluate(({ told }) => told)).toEqual(['ready on main']);
});
