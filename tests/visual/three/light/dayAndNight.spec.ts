import { expect, longIf, test } from '../../../support/fixtures.ts';

type Cases = typeof import('./dayAndNight.cases.ts');

const CASES = '/tests/visual/three/light/dayAndNight.cases.ts';

type Rgb = readonly number[];

const light = ([red, green, blue]: Rgb) => 0.2126 * red + 0.7152 * green + 0.0722 * blue;
const warmth = ([red, , blue]: Rgb) => red / blue;

/** What the mean colours of smoke, on the left and on the right, are compared with those at noon. */
const EXPECTED: Readonly<Record<string, (left: Rgb, right: Rgb, noon: Rgb) => boolean>> = {
  noon: (left, right) => Math.min(light(left), light(right)) > 140,
  dusk: (left, right, noon) => warmth(left) > 1.25 * warmth(noon) && light(left) > light(right),
  night: (_left, right, noon) => light(right) < 0.6 * light(noon) && warmth(right) < 0.8,
  'a red lamp': (left, right) => warmth(right) > 1.3 && warmth(right) > 1.2 * warmth(left),
  'a blue and an orange lamp': (left, right) => warmth(left) < 0.75 && warmth(right) > 1.25,
  'in the cone of a spot light': (_left, right, noon) => light(right) > 0.6 * light(noon),
  'beside the cone of a spot light': (_left, right, noon) => light(right) < 0.5 * light(noon),
};

/** Numbers of tone mappings of three.js. */
const [REINHARD, NEUTRAL] = [2, 7] as const;

for (const [name, isAsExpected] of Object.entries(EXPECTED)) {
  test(`smoke belongs to its scene, also under a composer: ${name}${longIf(name !== 'night')}`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const noon = await cases.evaluate((module, given) => module.measure('noon', given), REINHARD);
    const of = (given: typeof REINHARD | typeof NEUTRAL) =>
      cases.evaluate((module, [one, by]) => module.measure(one, by), [name, given] as const);
    const { canvas, smoke, apart } = await of(REINHARD);
    const all = JSON.stringify({ ...canvas, noon: noon.canvas });
    expect(smoke).toBeGreaterThan(1500);
    expect(isAsExpected(canvas.left, canvas.right, noon.canvas.right), all).toBe(true);
    expect(apart).toBeLessThanOrEqual(2);
    // Neutral cannot show colours that are bright and saturated, but keeps their hue.
    const neutral = await of(NEUTRAL);
    for (const half of ['left', 'right'] as const) {
      const [shown, wanted] = [neutral.composed[half], neutral.canvas[half]].map(warmth);
      expect(Math.abs(Math.log(shown / wanted)), `${half}: ${shown}, ${wanted}`).toBeLessThan(0.1);
    }
  });
}
