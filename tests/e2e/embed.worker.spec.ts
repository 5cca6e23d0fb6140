import { expect, test } from '../support/fixtures.ts';

type Cases = typeof import('./embed.cases.ts');
const CASES = '/tests/e2e/embed.cases.ts';

test('a worker draws the same picture as the main thread', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const report = await cases.evaluate((module) => module.compareThreads());
  expect(report.threads).toEqual(['worker', 'main']);
  expect(report.hashes[0]).toBe(report.hashes[1]);
  expect(report.colors).toBeGreaterThan(20);
  expect(report).toMatchObject({ differing: 0, differingOnPage: 0, differingShown: 0 });
});
