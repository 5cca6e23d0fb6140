import { expect, test } from '../../../support/fixtures.ts';

for (const camera of ['perspective', 'offAxis', 'orthographic']) {
  test(`windowDepth equals projection times position: ${camera}`, async ({ load }) => {
    const cases = await load<typeof import('./depth.cases.ts')>('/tests/visual/renderer/passes/depth.cases.ts');
    const error = await cases.evaluate((module, name) => module.largestError(name), camera);
    // Two steps of a 24-bit depth buffer.
    expect(error).toBeLessThan(2 / 2 ** 24);
  });
}
