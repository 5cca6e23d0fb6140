import { expect, test } from '../../../support/fixtures.ts';

type Cases = typeof import('./selle.cases.ts');
const CASES = '/tests/visual/renderer/passes/selle.cases.ts';

test('selle draws closed lines one pixel wide exactly where the depth gap is over the threshold, and three flat colours', async ({
  load,
}) => {
  const cases = await load<Cases>(CASES);
  const [under, over] = await cases.evaluate((module) => [module.depthLines(0.9), module.depthLines(1.1)]);
  for (const { missing, extra, thickest, isClosed } of [under, over]) {
    expect({ missing, extra, thickest, isClosed }).toEqual({ missing: 0, extra: 0, thickest: 1, isClosed: true });
  }
  // The line is around the larger puff. With the larger gap there is also a line around the smaller one in front of it.
  expect(under.line).toBeGreaterThan(90);
  expect(over.line - under.line).toBeGreaterThan(20);
  // Page, fully lit smoke, ink.
  expect(over.colors).toBe(3);
});
