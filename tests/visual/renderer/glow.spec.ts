import { expect, longIf, test } from '../../support/fixtures.ts';

type Cases = typeof import('./glow.cases.ts');
const CASES = '/tests/visual/renderer/glow.cases.ts';

for (const [name, values] of Object.entries({
  'simplified light': {},
  'plain light': { 'style.simplify': 0 },
  'a lamp that fades': { 'light.kind': 'lamp', 'light.decay': 1, 'style.simplify': 0 },
  'a lamp that fades on simplified light': { 'light.kind': 'lamp', 'light.decay': 1 },
} as const)) {
  test(`flames that glow keep their colours at night and light dark smoke: ${name}${longIf(name !== 'simplified light')}`, async ({
    load,
  }) => {
    const cases = await load<Cases>(CASES);
    const { flames, smoke, ...found } = await cases.evaluate((module, given) => module.changes(given), values);
    const all = JSON.stringify({ flames, smoke, ...found });
    expect(Math.min(flames, smoke), all).toBeGreaterThan(400);
    // Several lights are drawn with N.L in 8 bits, which moves borders between tones.
    expect(found.glowing, all).toBeLessThanOrEqual(0.003 * flames);
    expect(found.dull, all).toBeGreaterThan(100);
    expect(found.byDay, all).toBeGreaterThan(100);
    expect(found.atNight, all).toBeLessThan(60);
    expect(found.byFire, all).toBeGreaterThan(found.atNight + 40);
  });
}

for (const [preset, step] of [
  ['campfire-night', 240],
  ['rocket-night', 150],
] as const) {
  test(`the fire of ${preset} lights the ground, which does not flicker`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const { byFire, dark } = await cases.evaluate((module, given) => module.ground(...given), [
      preset,
      step,
      5,
    ] as const);
    const all = JSON.stringify({ byFire, dark });
    expect(Math.min(...byFire), all).toBeGreaterThan(1.25 * dark);
    // Smoke moves over the ground, and its temperature falls.
    byFire.slice(1).forEach((now, index) => expect(Math.abs(now / byFire[index] - 1), all).toBeLessThan(0.05));
  });
}
