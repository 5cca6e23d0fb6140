import { expect, test } from '../../../support/fixtures.ts';

type Cases = typeof import('./light.cases.ts');

const CASES = '/tests/visual/three/light/light.cases.ts';

const LIGHTS = {
  reference: 3,
  'a red key light': 3,
  'half a key light': 3,
  'a strong key light': 3,
  'no key light': 1,
  'a hidden key light': 1,
  'ambient light of two colours': 3,
  'no ambient light': 3,
  'a hemisphere light of one colour': 3,
  'a far lamp': 3,
  'a lamp that does not decay': 3,
  'a lamp that ends': 3,
  'the cone of a spot light': 3,
  'beside the cone of a spot light': 1,
};

for (const [name, tones] of Object.entries(LIGHTS)) {
  test(`smoke has the colours of a toon material under ${name}`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const { smoke, ball } = await cases.evaluate((module, given) => module.underLights(given), name);
    expect(smoke, JSON.stringify({ smoke, ball })).toHaveLength(tones);
    expect(ball).toHaveLength(tones);
    const gaps = smoke.flatMap((color, tone) => color.map((channel, at) => Math.abs(channel - ball[tone][at])));
    expect(Math.max(...gaps), JSON.stringify({ smoke, ball })).toBeLessThanOrEqual(2);
  });
}

for (const name of [
  'a lamp that decays',
  'simplified light',
  'a lamp that ends',
  'a lamp that ends before the smoke object',
  'a spot light on one puff',
  'a spot light whose edge is at the other puff',
  'smoke of half the size',
]) {
  test(`each puff has the light that reaches it: ${name}`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const { smoke, expected } = await cases.evaluate((module, given) => module.byLamp(given), name);
    for (const half of [0, 1] as const) {
      const [found, wanted] = [smoke[half], expected[half]];
      const both = JSON.stringify({ found, wanted });
      expect(found, both).toHaveLength(wanted.length);
      const gaps = found.flatMap((color, tone) => color.map((channel, at) => Math.abs(channel - wanted[tone][at])));
      expect(Math.max(...gaps), both).toBeLessThanOrEqual(2);
    }
    expect(expected[0]).not.toEqual(expected[1]);
  });
}

test('the light of the style is that of no scene, and the key light of smoke can be replaced', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  expect(await cases.evaluate((module) => module.changes())).toEqual({
    changed: 0,
    same: 0,
    moved: true,
    casters: [true, false, false],
  });
});
