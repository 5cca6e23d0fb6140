/** Forty stages at once, and two hundred created and disposed one by one without leaks. */
import type { Page } from '@playwright/test';
import { expect, test } from '../../../support/fixtures.ts';
import { expectBack, expectMany } from './many.ts';

type ManyCases = typeof import('./many.cases.ts');
type ProvokedCases = typeof import('../../page/element/provoked.cases.ts');
type Shared = typeof import('../../../../src/stage/remote/openHere.ts');
type Load = typeof import('../../../../src/simulator/load.ts');
const SHARED = '/src/stage/remote/openHere.ts';
const LOAD = '/src/simulator/load.ts';
const [FIRST, MORE] = [20, 180];
/** The engine keeps some code and feedback; leaked stages would need twice as much. */
const SLACK_BYTES = 1_000_000;

test.use({ ownPage: true, allowed: /context lost|CONTEXT_LOST/i });

for (const thread of ['worker', 'main'] as const) {
  test(`forty stages share a context, and only those in view play: ${thread}`, async ({ load, blank }) => {
    await expectMany({ load, blank }, [40, 12], thread);
  });
}

test('forty elements recover from two lost contexts', async ({ load, blank }) => {
  await expectBack({ load, blank }, 40, 'worker');
});

test('the heap of the main thread does not grow, and its context is released', async ({ load, blank }) => {
  const many = await load<ManyCases>('/tests/e2e/stage/remote/many.cases.ts');
  const shared = await load<Shared>(SHARED);
  const comeAndGo = (rounds: number) => many.evaluate((module, count) => module.comeAndGo(count, 'main'), rounds);
  await comeAndGo(FIRST);
  const before = await usedBytes(blank);
  const context = await shared.evaluateHandle(({ threadDevice }) => {
    const device = threadDevice.acquire()!;
    threadDevice.release(device);
    return device.renderer.getContext();
  });
  await comeAndGo(MORE);
  expect((await usedBytes(blank)) - before).toBeLessThan(SLACK_BYTES);
  await expect.poll(() => context.evaluate((used) => used.isContextLost())).toBe(true);
});

test('the heap of a page does not grow while elements are added and removed', async ({ load, blank }) => {
  const cases = await load<ProvokedCases>('/tests/e2e/page/element/provoked.cases.ts');
  const comeAndGo = (rounds: number) => cases.evaluate((module, count) => module.comeAndGo(count, 'auto'), rounds);
  await comeAndGo(FIRST);
  const before = await usedBytes(blank);
  await comeAndGo(MORE);
  expect((await usedBytes(blank)) - before).toBeLessThan(SLACK_BYTES);
  await expect.poll(() => blank.workers().length).toBe(0);
});

test('a worker releases textures, geometries, programs and WASM memory', async ({ load, blank }) => {
  const many = await load<ManyCases>('/tests/e2e/stage/remote/many.cases.ts');
  const comeAndGo = (rounds: number) => many.evaluate((module, count) => module.comeAndGo(count, 'worker'), rounds);
  await comeAndGo(FIRST);
  const before = await held(blank);
  await comeAndGo(MORE);
  const after = await held(blank);
  expect({ ...after, wasm: 0 }).toEqual({ ...before, wasm: 0 });
  // The next stage may start before the previous one is disposed. A leak of all stages would need four times as much.
  expect(after.wasm - before.wasm).toBeLessThan(1024 * 1024);
  await expect.poll(() => blank.workers().length).toBe(0);
});

async function usedBytes(page: Page): Promise<number> {
  const session = await page.context().newCDPSession(page);
  await session.send('HeapProfiler.collectGarbage');
  const { usedSize } = await session.send('Runtime.getHeapUsage');
  await session.detach();
  return usedSize;
}

/** Memory of the worker's device and simulator. */
async function held(page: Page) {
  const [worker] = page.workers();
  const modules = await worker.evaluateHandle(`Promise.all([import('${SHARED}'), import('${LOAD}')])`);
  return worker.evaluate(async (list) => {
    const [{ threadDevice }, { loadSimulators }] = list as [Shared, Load];
    const device = threadDevice.acquire()!;
    threadDevice.release(device);
    const { info } = device.renderer;
    const { memory } = (await loadSimulators({ physics: false })).module;
    return { ...info.memory, programs: info.programs?.length, wasm: memory.buffer.byteLength };
  }, modules);
}
