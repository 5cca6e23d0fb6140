import { expect, longIf, test } from '../../../support/fixtures.ts';

type Clipping = typeof import('./clipping.cases.ts');
const CLIPPING = '/tests/visual/three/target/clipping.cases.ts';

for (const [look, scale] of [
  ['lobes', 1],
  ['lobes', 1.2],
  ['billboards', 1],
  ['strokes', 1],
  ['simplified', 1],
] as const) {
  const tag = longIf(scale === 1);
  test(`renderer.clippingPlanes cut smoke where it is: ${look}, scale ${scale}${tag}`, async ({ load }) => {
    const cases = await load<Clipping>(CLIPPING);
    const { results, first } = await cases.evaluate((module, input) => module.cuts(...input), [look, scale] as const);
    for (const { name, left, changed, gone, kept, others } of results) {
      expect({ name, left, changed, others }).toEqual({ name, left: 0, changed: expect.closeTo(0, -1), others: 0 });
      expect(kept, name).toBeGreaterThan(150);
      if (name === 'nothing') expect(gone).toBe(0);
      else expect(gone, name).toBeGreaterThan(300);
    }
    expect(first).toBe(results[0].kept);
  });
}
