/** The pictures in docs/. `UPDATE_GOLDENS=1` writes them. */
import { bytesOf, expectGolden } from '../../support/goldens.ts';
import { expect, longIf, test } from '../../support/fixtures.ts';

type Recipes = typeof import('./recipes.cases.ts');
/** Largest size of a picture, bytes. */
const LARGEST = 75_000;
/** Presets that timelines make, and the seconds of their moments. */
const MOMENTS = { title: [5.8, 10.6], firework: [1.4, 3.8, 5.8], 'wisp-valentine': [1.6, 3, 6] };

for (const recipe of [
  'composer',
  'mirror',
  'fog',
  'looks',
  'bursts',
  'timeline',
  'drivers',
  'flows',
  'shapes',
] as const) {
  const tag = longIf(recipe !== 'composer');
  test(`the recipe ${recipe} shows the picture of the documentation${tag}`, async ({ load }, testInfo) => {
    const cases = await load<Recipes>('/tests/visual/three/recipes.cases.ts');
    const picture = await bytesOf(await cases.evaluateHandle((module, name) => module.pictureOf(name), recipe));
    expect(picture.length).toBeLessThan(LARGEST);
    await expectGolden(picture, { name: `../../../docs/images/${recipe}`, tolerance: 8, outliers: 40 }, testInfo);
  });
}

for (const [preset, seconds] of Object.entries(MOMENTS)) {
  test(`${preset} shows the picture of the documentation${longIf(true)}`, async ({ load }, testInfo) => {
    const cases = await load<Recipes>('/tests/visual/three/recipes.cases.ts');
    const blob = await cases.evaluateHandle((module, [name, times]) => module.momentsOf(name, times), [
      preset,
      seconds,
    ] as const);
    const picture = await bytesOf(blob);
    expect(picture.length).toBeLessThan(LARGEST);
    await expectGolden(picture, { name: `../../../docs/images/${preset}`, tolerance: 8, outliers: 40 }, testInfo);
  });
}
