import { expect, test } from '../../../support/fixtures.ts';

type Cases = typeof import('./surfaces.cases.ts');
const CASES = '/tests/visual/renderer/passes/surfaces.cases.ts';

for (const creases of [true, false]) {
  const among = creases ? 'beside creases' : 'without creases';
  test(`the outline of a moving mesh is closed where it touches another, and not inside it: ${among}`, async ({
    load,
  }) => {
    const cases = await load<Cases>(CASES);
    const { outline, open, inside } = await cases.evaluate((module, asked) => module.outlineOnSlab(asked), creases);
    expect(outline).toBeGreaterThan(300);
    expect(open).toBe(0);
    expect(inside).toBe(0);
  });
}

test('a scene of many moving meshes takes few draw calls', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  expect(await cases.evaluate((module) => module.callsOfTrain())).toBeLessThanOrEqual(13);
});

test('a surface that is out of sight draws no triangles', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { triangles, isSame } = await cases.evaluate((module) => module.comesAndGoes());
  const [shown, hidden, again, without] = triangles;
  // Twelve triangles of the box, twice for its hulls, and more for its volume.
  expect(shown).toBeGreaterThan(hidden + 40);
  expect(again).toBe(shown);
  expect(hidden).toBe(without);
  expect(isSame).toEqual([false, true, false, true]);
});

for (const hasRaisedHulls of [true, false]) {
  test(`a smoke draws at other sizes: ${hasRaisedHulls ? 'with' : 'without'} raised hulls`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const { drawn, error } = await cases.evaluate((module, asked) => module.resized(asked), hasRaisedHulls);
    expect(error).toBe(0);
    expect(drawn[0]).toBeGreaterThan(60);
    expect(drawn[1]).toBeGreaterThan(1.8 * drawn[0]);
    expect(drawn[2]).toBeGreaterThan(1.5 * drawn[1]);
  });
}
