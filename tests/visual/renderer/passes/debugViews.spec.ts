import { expect, longIf, test } from '../../../support/fixtures.ts';

type Cases = typeof import('./debugViews.cases.ts');
const CASES = '/tests/visual/renderer/passes/debugViews.cases.ts';

for (const form of ['lobes', 'billboards'] as const) {
  test(`${form}: lit, unlit, ink and counts show the targets${longIf(form === 'billboards')}`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const { wrong, judged, error } = await cases.evaluate((module, shape) => module.compareViews(shape), form);
    expect(error).toBe(0);
    for (const view of ['lit', 'unlit', 'ink', 'counts'] as const) {
      expect(judged[view], view).toBeGreaterThan(2_000);
      expect(wrong[view], view).toBe(0);
    }
  });

  test(`${form}: normals reproduce the tones`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const { puff, unexplained } = await cases.evaluate((module, shape) => module.normalsAndTones(shape), form);
    expect(puff).toBeGreaterThan(5_000);
    expect(unexplained).toBe(0);
  });
}

test('depth is shown between the nearest and the farthest of the scene', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { worst, pixels } = await cases.evaluate((module) => module.depthError());
  expect(pixels).toBeGreaterThan(5_000);
  expect(worst).toBeLessThan(1.5);
});

test('overdraw counts bodies and volumes, hidden or not', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { bodies, expected, withVolumes } = await cases.evaluate((module) => module.overdraw());
  expect(bodies).toEqual(expected);
  expect(withVolumes).toBeGreaterThan(2);
});

test('the coverage grid is drawn in place and covers only smoke', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { tinted, wrong, missing, clear } = await cases.evaluate((module) => module.coverageTints());
  expect(tinted).toBeGreaterThan(1_000);
  expect(clear).toBe(0);
  // Single precision rounds the borders of cells differently.
  expect(wrong + missing).toBeLessThan(0.002 * tinted);
});
