import { expect, test } from '../../support/fixtures.ts';

type Cases = typeof import('./flat.cases.ts');
const CASES = '/tests/visual/renderer/flat.cases.ts';

test('the self-test detects whether written depth is used, and can be made to fail', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  expect(await cases.evaluate((module) => module.selfTest())).toEqual({ passes: true, notified: false, error: 0 });
  expect(await cases.evaluate((module) => module.selfTestWithoutWriting())).toBe(false);
});

test('a context that is lost before the self-test does not make puffs flat', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  expect(await cases.evaluate((module) => module.selfTestWithoutContext())).toBe(true);
});

for (const view of ['ordinary', 'lamp', 'orthographic']) {
  test(`flat smoke, ink and shadow nearly match those with written depth: ${view}`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const report = await cases.evaluate((module, name) => module.agreement(name), view);
    console.log(`flat against nailboards, ${view}:`, report);
    expect(report.error).toBe(0);
    expect(report.shadow).toBeGreaterThan(1_000);
    expect(report.shadowAgreed / report.shadow).toBeGreaterThan(0.95);
    expect(report.shadowAgreed / report.flatShadow).toBeGreaterThan(0.94);
    expect(report.smokeAgreed / report.smoke).toBeGreaterThan(0.9);
    expect(report.flatInk / report.ink).toBeGreaterThan(0.9);
    expect(report.flatInk / report.ink).toBeLessThan(1.5);
  });
}

test('flat: 512 coincident casters stay dark', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { shadowed, lit } = await cases.evaluate((module) => module.coincident(512));
  expect(shadowed).toBeGreaterThan(300);
  expect(lit).toBe(0);
});

test('flat: a lone puff masks none of its own lit pixels', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { lit, masked } = await cases.evaluate((module) => module.flatSelfMasked(60));
  expect(lit).toBeGreaterThan(30_000);
  expect(masked).toBe(0);
});

test('flat: a stage reports it and draws smoke, ink and shadow @long', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { writesDepth, ink, smoke, shadowed } = await cases.evaluate((module) => module.flatStage());
  expect(writesDepth).toBe(false);
  for (const pixels of [ink, smoke, shadowed]) expect(pixels).toBeGreaterThan(200);
});
