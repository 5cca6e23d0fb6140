import { expect, longIf, test } from '../../../support/fixtures.ts';

type Cases = typeof import('./patterns.cases.ts');
const CASES = '/tests/visual/three/target/patterns.cases.ts';

for (const pattern of ['dots', 'lines', 'crosshatch', 'grain'] as const) {
  for (const hasStencil of [true, false]) {
    test(`${pattern} on smoke and on the host's objects in its shadow ${hasStencil ? 'with' : 'without'} a stencil buffer${longIf(pattern !== 'dots')}`, async ({
      load,
    }) => {
      const cases = await load<Cases>(CASES);
      const input = [{ 'style.pattern': pattern }, hasStencil] as const;
      const found = await cases.evaluate((module, given) => module.marked(...given), input);
      console.log(pattern, JSON.stringify(found));
      expect(found.smoke).toBeGreaterThan(300);
      expect(found.shadow).toBeGreaterThan(300);
      expect(found.onShadow / found.shadow).toBeGreaterThan(0.25);
      expect(found.onShadow / found.shadow).toBeLessThan(0.85);
      // Samples at edges of the canvas.
      expect(found.beside).toBeLessThan(8);
    });
  }
}

test('marks on tones leave the objects of the host as they are', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const values = { 'style.pattern': 'dots', 'style.patternOn': 'tones', 'style.tones': 3 } as const;
  const found = await cases.evaluate((module, given) => module.marked(given, true), values);
  expect(found.smoke).toBeGreaterThan(100);
  expect(found).toMatchObject({ onShadow: 0 });
});
