import { expect, test } from '../../../support/fixtures.ts';

type Cases = typeof import('./additionalLights.cases.ts');

const CASES = '/tests/visual/three/light/additionalLights.cases.ts';

/** Sets of lights that many pixels of smoke are in, one bit for each. */
const LIT: Readonly<Record<string, readonly number[]>> = {
  'a blue moon': [0, 1],
  'a blue moon and an orange lantern': [1, 2, 3],
  'three lights': [1, 2, 3, 5, 6],
  'simplified light': [1, 2, 3],
  'light that follows the whole form': [1, 2],
  billboards: [1, 2, 3],
  'stretched puffs': [1, 2, 3],
  'a key light that decays': [0, 1],
  'smoke that is scaled and turned': [1, 2, 3],
  'a light that is hidden': [0],
  'a light of intensity 0': [0],
  'beside the cone of a spot light': [0],
};

for (const [name, sets] of Object.entries(LIT)) {
  test(`each light adds C KL of Eq. 2: ${name}`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const { found, expected } = await cases.evaluate((module, given) => module.underLights(given), name);
    const gapTo = (color: number[], other: number[]) => Math.max(...color.map((c, at) => Math.abs(c - other[at])));
    const nearest = found.map((color) => {
      const [first] = expected.toSorted((one, other) => gapTo(color, one.color) - gapTo(color, other.color));
      return { color, set: first.set, gap: gapTo(color, first.color) };
    });
    const all = JSON.stringify({ nearest, expected });
    expect(found.length, all).toBeGreaterThan(1);
    expect(Math.max(...nearest.map(({ gap }) => gap)), all).toBeLessThanOrEqual(2);
    expect([...new Set(nearest.map(({ set }) => set))], all).toEqual(expect.arrayContaining([...sets]));
  });
}

for (const [name, values] of Object.entries({ plain: {}, simplified: { 'style.simplify': 1 } })) {
  test(`no light jumps when a fourth one takes the place of the third: ${name}`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const { step, all } = await cases.evaluate((module, given) => module.whileLightsSwap(given), values);
    expect(all).toBeGreaterThan(50_000);
    expect(step, `${step} of ${all}`).toBeLessThan(0.12 * all);
  });

  test(`a blue and an orange lamp both read on smoke: ${name}`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const [left, right] = await cases.evaluate((module, given) => module.betweenLamps(given), values);
    const bluest = ([red, , blue]: readonly number[]) => blue / red;
    expect(bluest(left), JSON.stringify({ left, right })).toBeGreaterThan(3 * bluest(right));
  });
}

test('smoke in the light of its style has no lights of the scene, and a faint light is not seen', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { styled, most } = await cases.evaluate((module) => module.ofFaintLights());
  expect(styled).toBe(0);
  expect(most).toBeLessThanOrEqual(1);
});
