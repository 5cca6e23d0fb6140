import { expect, test } from '../../support/fixtures.ts';

type Cases = typeof import('./meshVolumes.cases.ts');
const CASES = '/tests/visual/passes/meshVolumes.cases.ts';

test('a lamp that replaces a sun changes the shadow of a mesh at once', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { shadowed, stale } = await cases.evaluate((module) => module.staleAfterSun());
  expect(shadowed).toBeGreaterThan(200);
  expect(stale).toBe(0);
});

const ABOVE = [0.1, 1, 0.05] as const;
const VIEWS = {
  'from outside': [[1, 1.5, 4], [0, -1, 0], [-0.3, 1, 0.8]],
  'from above the shadow': [[1, 1.5, 4], [0, -1, 0], ABOVE],
  'from the shadow': [[0, -0.5, 0.25], [0, -1, -0.2], ABOVE],
  'with a near plane in the shadow': [[0.38, -0.6, 0], [0, -1, 0], ABOVE],
  'against the light': [[0, -0.5, 4], [0, -0.7, 0], [0, 0.75, -1]],
} as const; // prettier-ignore

for (const [name, view] of Object.entries(VIEWS)) {
  test(`the shadow of meshes, seen ${name}, is that of closed volumes`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const seen = await cases.evaluate((module, places) => module.shadowSeenFrom(places), view);
    for (const kind of ['shadowed', 'lit'] as const) expect(seen[kind], kind).toBeGreaterThan(50);
    expect([seen.wrong, seen.changed]).toEqual([0, 0]);
  });
}
