/** Injected faults and lost contexts, seen through the element: it recovers, or it gives up and reports an error. */
import type { JSHandle, Page } from '@playwright/test';
import { expect, longIf, test } from '../../../support/fixtures.ts';
import type { LoadModule } from '../../../support/modules.ts';
import type { Shown } from './provoked.cases.ts';
import { changeContext, restoreLate, setTimeouts } from '../../stage/remote/context.ts';
import { expectBack } from '../../stage/remote/many.ts';

type Cases = typeof import('./provoked.cases.ts');
const CASES = '/tests/e2e/page/element/provoked.cases.ts';

test.use({ ownPage: true, allowed: /context lost|context restored|CONTEXT_LOST/i });

async function expectGivenUp(load: LoadModule, shown: JSHandle<Shown>, notified: string[]): Promise<void> {
  const cases = await load<Cases>(CASES);
  await expect.poll(() => shown.evaluate((one) => one.notified)).toEqual(notified);
  expect(await cases.evaluate((module, one) => module.isGivenUp(one), shown)).toBe(true);
}

for (const thread of ['main', 'worker'] as const) {
  const tag = longIf(thread === 'main');
  test(`a simulator without memory leaves the poster and emits a SimulatorError: ${thread}${tag}`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const shown = await cases.evaluateHandle((module, where) => module.show(where, { fault: 'outOfMemory' }), thread);
    await expectGivenUp(load, shown, ['SimulatorError']);
  });
}

for (const thread of ['main', 'worker'] as const) {
  const tag = longIf(thread === 'worker');
  test(`all smoke recovers from a context that is lost twice: ${thread}${tag}`, async ({ load, blank }) => {
    await expectBack({ load, blank }, 2, thread);
  });

  test(`a context lost too often, or not restored after the start, ends the smoke until other smoke starts: ${thread} @long`, async ({
    load,
    blank,
  }) => {
    const cases = await load<Cases>(CASES);
    const shown = await cases.evaluateHandle((module, where) => module.show(where), thread);
    const notified = () => shown.evaluate((one) => one.notified);
    const ready = `ready on ${thread}`;
    await expect.poll(notified).toEqual([ready]);
    const drawing = () => (thread === 'main' ? blank : blank.workers().at(-1)!);
    await setTimeouts(drawing(), 'endless');
    for (let loss = 0; loss < 3; ++loss) {
      await changeContext(drawing(), 'loseContext');
      await changeContext(drawing(), 'restoreContext');
    }
    await changeContext(drawing(), 'loseContext');
    await expectGivenUp(load, shown, [ready, 'ContextError']);
    await shown.evaluate(({ element }) => element.setAttribute('src', '#preset=wisp'));
    await expect.poll(notified).toEqual([ready, 'ContextError', ready]);
    // The context is lost while the next smoke starts, which may be blank before it gives up. The long-idle worker has
    // been replaced by another one.
    await setTimeouts(drawing(), 'none');
    const options = { fault: 'contextLostInStart' } as const;
    const late = await cases.evaluateHandle((module, given) => module.show(...given), [thread, options] as const);
    await expect.poll(() => late.evaluate((one) => one.notified.at(-1))).toBe('ContextError');
    expect(await cases.evaluate((module, one) => module.isGivenUp(one), late)).toBe(true);
    await expectGivenUp(load, shown, [ready, 'ContextError', ready, 'ContextError']);
  });
}

for (const thread of ['main', 'worker'] as const) {
  test(`smoke of a context that is lost for good restarts by its button or by a late restoration: ${thread} @long`, async ({
    load,
    blank,
  }) => {
    const cases = await load<Cases>(CASES);
    const shown = await cases.evaluateHandle((module, where) => module.show(where), thread);
    const notified = () => shown.evaluate((one) => one.notified);
    const ready = `ready on ${thread}`;
    await expect.poll(notified).toEqual([ready]);
    const drawing = () => (thread === 'main' ? blank : blank.workers().at(-1)!);
    await setTimeouts(drawing(), 'none');
    await changeContext(drawing(), 'loseContext');
    await expectGivenUp(load, shown, [ready, 'ContextError']);
    await restoreLate(drawing());
    await expect.poll(notified).toEqual([ready, 'ContextError', ready]);
    await cases.evaluate((module, one) => module.allDraw([one]), shown);
    await changeContext(drawing(), 'loseContext');
    await expectGivenUp(load, shown, [ready, 'ContextError', ready, 'ContextError']);
    await blank.getByRole('button', { name: 'Restart smoke' }).click();
    await expect.poll(notified).toEqual([ready, 'ContextError', ready, 'ContextError', ready]);
    await cases.evaluate((module, one) => module.allDraw([one]), shown);
    await expect(blank.getByRole('button', { name: 'Pause smoke' })).toBeVisible();
  });
}

for (const thread of ['main', 'worker'] as const) {
  for (const place of ['the page', 'a canvas of the page'] as const) {
    test(`puff() on ${place} draws on a new context after one that is lost for good: ${thread} @long`, async ({
      load,
      blank,
    }) => {
      const cases = await load<Cases>(CASES);
      const drawing = () => (thread === 'main' ? blank : blank.workers().at(-1)!);
      let puff = await cases.evaluateHandle((module, given) => module.puffOn(...given), [place, thread] as const);
      const begin = () => cases.evaluateHandle((module, one) => module.puffs(one), puff);
      for (const makesAnother of [false, true]) {
        const call = await begin();
        await setTimeouts(drawing(), 'none');
        await changeContext(drawing(), 'loseContext');
        expect(await call.evaluate(({ ends }) => ends)).toMatch(/^ContextError/);
        await expect.poll(() => cases.evaluate((module) => module.colorsLeft())).toBe(1);
        if (makesAnother && place !== 'the page') puff = await cases.evaluateHandle((module) => module.ownPuff());
      }
      const call = await begin();
      await puff.evaluate((one) => one.clear());
      expect(await call.evaluate(({ ends }) => ends)).toBe('done');
      expect(await blank.locator('canvas').count()).toBeLessThan(2);
    });
  }
}

test('puff() draws on a canvas whose last puff was disposed', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  for (const round of [1, 2]) {
    const puff = await cases.evaluateHandle((module) => module.ownPuff());
    const call = await cases.evaluateHandle((module, one) => module.puffs(one), puff);
    await puff.evaluate((one) => one.dispose());
    expect(await call.evaluate(({ ends }) => ends), `puff ${round}`).toBe('done');
    await expect.poll(() => cases.evaluate((module) => module.colorsLeft())).toBe(1);
  }
});

/** Advances the clock by this number of heartbeat intervals. */
async function beats(page: Page, count: number): Promise<void> {
  for (let beat = 0; beat < count; ++beat) await page.clock.fastForward(10_000);
}

test('a worker that ends during the start is detected, and the next smoke has a new one', async ({ load, blank }) => {
  await blank.clock.install();
  const cases = await load<Cases>(CASES);
  const shown = await cases.evaluateHandle((module) => module.show('worker', { fault: 'workerSilent' }));
  await expect.poll(() => shown.evaluate(({ element }) => element.shadowRoot!.querySelector('canvas'))).not.toBeNull();
  await beats(blank, 5);
  expect(await shown.evaluate(({ notified }) => notified)).toEqual([]);
  await beats(blank, 9);
  await expectGivenUp(load, shown, ['SimulatorError']);
  const next = await cases.evaluateHandle((module) => module.show('auto'));
  await expect.poll(() => next.evaluate(({ notified }) => notified)).toEqual(['ready on worker']);
  await expect.poll(() => blank.workers().length).toBe(1);
});

/** Ends the worker of a page, by close() or by an exception, and waits until the page detects it. */
async function kill(page: Page, way: 'close' | 'throw'): Promise<void> {
  await page.workers()[0].evaluate((how) => {
    setTimeout(() => {
      if (how === 'close') return globalThis.close();
      throw new Error('out of order');
    });
  }, way);
  await expect.poll(() => page.workers().length).toBe(0);
  if (way === 'close') await beats(page, 14);
}

test('a worker that ends while playing ends all its smoke, which can restart three times @long', async ({
  load,
  blank,
}) => {
  await blank.clock.install();
  const cases = await load<Cases>(CASES);
  const shown = await cases.evaluateHandle((module) => module.showSome(2, 'worker'));
  const notified = () => shown.evaluate((all) => all.map((one) => one.notified.splice(0).join()));
  const areGivenUp = () => cases.evaluate((module, all) => all.every(module.isGivenUp), shown);
  for (const way of ['close', 'throw', 'close'] as const) {
    await expect.poll(() => shown.evaluate((all) => all.every(({ element }) => element.playing))).toBe(true);
    await cases.evaluate((module, all) => module.allDraw(all), shown);
    expect(await notified()).toEqual(Array(2).fill('ready on worker'));
    expect(blank.workers()).toHaveLength(1);
    await kill(blank, way);
    await expect.poll(areGivenUp).toBe(true);
    expect(await notified()).toEqual(Array(2).fill('SimulatorError'));
    await shown.evaluate(([first, second]) => {
      first.element.setAttribute('src', `#preset=wisp&seed=${Math.random()}`);
      second.element.remove();
      setTimeout(() => document.body.append(second.element));
    });
  }
  await expect.poll(areGivenUp).toBe(true);
  expect(await notified()).toEqual(Array(2).fill('SimulatorError'));
  expect(blank.workers()).toHaveLength(0);
  const next = await cases.evaluateHandle((module) => module.show('auto'));
  await expect.poll(() => next.evaluate((one) => one.notified)).toEqual(['ready on main']);
});
