import type { Page } from '@playwright/test';
import { expect } from '../support/fixtures.ts';
import type { LoadModule } from '../support/modules.ts';

type Devices = typeof import('./cases/stageDevices.ts');

/** What a stage may leave on the heap, bytes: less than one column of its particles. */
const MOST_LEFT = 20_000;
const BATCH = 3;

/**
 * Makes and ends batches of stages, one stage after the other: their contexts are gone, and after the first batch the
 * memory grows no more. What the engine learns by and by about the code comes in some batches, what a stage leaves in all.
 */
export async function expectGone(load: LoadModule, page: Page, batches: number): Promise<void> {
  const cases = await load<Devices>('/tests/visual/cases/stageDevices.ts');
  const devTools = await page.context().newCDPSession(page);
  const heap = async () => {
    await devTools.send('HeapProfiler.collectGarbage');
    return (await devTools.send('Runtime.getHeapUsage')).usedSize;
  };
  const reports: { lost: number; wasmBytes: number; heap: number }[] = [];
  for (let batch = 0; batch < batches; ++batch) {
    reports.push({
      ...(await cases.evaluate((module, rounds) => module.comeAndGo(rounds), BATCH)),
      heap: await heap(),
    });
  }
  expect(reports.map(({ lost }) => lost)).toEqual(reports.map(() => BATCH));
  expect(new Set(reports.map(({ wasmBytes }) => wasmBytes)).size).toBe(1);
  const grown = reports.slice(1).map((report, at) => report.heap - reports[at].heap);
  // The very least might be a batch in which the engine forgot something.
  const [, second] = grown.toSorted((a, b) => a - b);
  expect(second).toBeLessThan(BATCH * MOST_LEFT);
}
