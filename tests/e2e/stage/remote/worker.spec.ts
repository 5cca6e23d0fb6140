/** Stages in a worker: the same pictures, one worker and one context for all, no effect on the page. */
import { expect, test } from '../../../support/fixtures.ts';
import { setTimeouts, changeContext } from './context.ts';

type Cases = typeof import('./stage.cases.ts');
const CASES = '/tests/e2e/stage/remote/stage.cases.ts';

test('a worker draws the same picture as the main thread', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const report = await cases.evaluate((module) => module.compareThreads());
  expect(report.threads).toEqual(['worker', 'main']);
  expect(report.hashes[0]).toBe(report.hashes[1]);
  expect(report.colors).toBeGreaterThan(20);
  expect(report.differing, 'on the page, drawn anew, and of the two').toEqual([0, 0, 0]);
});

test('errors have the same class and message in a worker as on the main thread', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const [worker, main] = await cases.evaluate((module) =>
    Promise.all([module.errors('worker'), module.errors('main')]),
  );
  expect(worker).toEqual(main);
  expect(worker.range).toMatchObject({ name: 'ParameterError', key: 'emission.rate', value: -5, isOurs: true });
  expect(worker.text?.message).toMatch(/^emission.rate cannot be “60”: it takes a number from 0/);
  expect(worker.unknown?.name).toBe('ParameterError');
  expect(worker.scene?.name).toBe('ParameterError');
  expect(worker.bytes?.name).toBe('SimulatorError');
  expect(worker.fraction).toMatchObject({ name: 'ParameterError', key: 'n', value: 1.5, isOurs: true });
  expect(worker.fraction?.message).toBe('n cannot be 1.5: it takes a whole number from 0 to 4294967295.');
  expect(worker.negativeStep).toMatchObject({ name: 'ParameterError', key: 'n', value: -1 });
  expect(worker.negativeSeek).toMatchObject({ name: 'ParameterError', key: 'seconds', value: -1 });
  expect(worker.negativeSeek?.message).toBe('seconds cannot be -1: it takes a number from 0.');
  expect(worker.negativeAdvance).toMatchObject({ name: 'ParameterError', key: 'seconds', value: -0.5 });
  expect(worker.noNumber).toMatchObject({ name: 'ParameterError', key: 'seconds' });
  expect(worker.after?.name).toBe('SimulatorError');
  expect(worker.isSame).toBe(true);
});

test('takes and states survive a round trip to the worker', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { hashes, inputs, isOfStart } = await cases.evaluate((module) => module.sendBytes());
  expect(new Set(hashes).size).toBe(1);
  expect({ inputs, isOfStart }).toEqual({ inputs: 2, isOfStart: true });
});

test('statistics have the GPU time of frames while they ask for it', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  for (const thread of ['worker', 'main'] as const) {
    const { before, timed, after } = await cases.evaluate((module, where) => module.timeGpu(where), thread);
    expect({ before, after }, thread).toEqual({ before: undefined, after: undefined });
    expect(timed, thread).toBeGreaterThan(0.1);
    expect(timed, thread).toBeLessThan(60_000);
  }
});

test('a playing stage sends no message without a listener', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const report = await cases.evaluate((module) => module.listen(module.watch()));
  expect(report.notified).toEqual([true, false]);
  expect(report.silent).toBe(0);
  expect(report.steps).toBeGreaterThan(0);
});

test('out of view a stage rests, and a paused one stays paused', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  expect(await cases.evaluate((module) => module.scroll())).toEqual({ away: 0, paused: 0 });
});

test('a start can be aborted at any moment', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  expect(await cases.evaluate((module) => module.abortStarts())).toEqual(['at once', 'soon', 'later']);
});

test.describe('on a separate page', () => {
  test.use({ ownPage: true, allowed: /context lost|context restored|CONTEXT_LOST/i });

  test('stages share one worker, which ends after the last of them', async ({ load, blank }) => {
    const cases = await load<Cases>(CASES);
    const seen = await cases.evaluateHandle((module) => module.watch());
    const counts = await cases.evaluate(async (module, count) => {
      const opened = await Promise.all([1, 2, 3].map(() => module.open()));
      for (const { stage } of opened) await stage.dispose();
      const again = await module.open();
      await again.stage.step(2);
      await again.stage.dispose();
      // Immediately: it would terminate itself after some seconds.
      return [count.workers, count.terminated];
    }, seen);
    expect(counts).toEqual([1, 0]);
    await expect.poll(() => blank.workers().length).toBe(0);
    expect(await seen.evaluate(({ workers, terminated }) => [workers, terminated])).toEqual([1, 1]);
    expect(await cases.evaluate(async (module) => (await module.open()).stage.thread)).toBe('worker');
  });

  test('a failure in the worker is reported to its stages and not to the page', async ({ load, blank }) => {
    const cases = await load<Cases>(CASES);
    const notified = await cases.evaluateHandle(async (module) => {
      const { stage } = await module.open();
      const error = new Promise<Error>((resolve) => stage.on('error', resolve));
      // Listening sends a message, and this call follows it.
      await stage.get();
      return { error };
    });
    await blank.workers()[0].evaluate(
      () =>
        void setTimeout(() => {
          throw new Error('out of order');
        }),
    );
    const { name, message } = await notified.evaluate(async ({ error }) => {
      const { name: its, message: words } = await error;
      return { name: its, message: words };
    });
    expect(name).toBe('SimulatorError');
    expect(message).toContain('out of order');
  });

  test('a worker sends heartbeats during many steps @long', async ({ load, blank }) => {
    const cases = await load<Cases>(CASES);
    // The heartbeat is not under test: the page's clock stops before its timeout.
    await blank.clock.install({ time: 0 });
    await blank.clock.pauseAt(1_000);
    const opened = await cases.evaluateHandle((module) => module.open());
    const [worker] = blank.workers();
    const said = await worker.evaluateHandle(() => {
      const [now, seen] = [performance.now.bind(performance), [] as unknown[]];
      // Each step appears to take longer than the ten-second interval of messages, but takes no real time.
      let ahead = 0;
      performance.now = () => now() + (ahead += 20_000);
      globalThis.postMessage = (message: unknown) => void seen.push(message);
      return seen;
    });
    await opened.evaluate(({ stage }) => stage.step(20));
    expect(await said.jsonValue()).toEqual(Array(20).fill('beat'));
  });

  test('all stages recover from a context that is lost twice @long', async ({ load, blank }) => {
    const cases = await load<Cases>(CASES);
    const opened = await cases.evaluateHandle(async (module) => {
      const two = await Promise.all([module.open(), module.open()]);
      for (const { stage } of two) await stage.step(100);
      return two;
    });
    const [worker] = blank.workers();
    await setTimeouts(worker, 'endless');
    await changeContext(worker, 'loseContext');
    await changeContext(worker, 'restoreContext');
    await changeContext(worker, 'loseContext');
    const rejected = await opened.evaluate(([{ stage }]) => stage.picture().catch((error: Error) => error.name));
    expect(rejected).toBe('ContextError');
    await opened.evaluate(([first, second]) => Promise.all([first.stage.step(50), second.stage.step(50)]));
    await changeContext(worker, 'restoreContext');
    const changed = await cases.evaluate(async (module, two) => {
      const alone = await module.open({ thread: 'main' });
      await alone.stage.step(150);
      const expected = await module.pixelsOf(await alone.stage.picture());
      return Promise.all(two.map(({ canvas }) => module.differingShown(canvas, expected)));
    }, opened);
    expect(changed).toEqual([0, 0]);
  });
});
