/** The pictures in docs/three.md. `UPDATE_GOLDENS=1` writes them. */
import { bytesOf, expectGolden } from '../../support/goldens.ts';
import { expect, longIf, test } from '../../support/fixtures.ts';

type Recipes = typeof import('./recipes.cases.ts');
/** Largest size of a picture, bytes. */
const LARGEST = 60_000;

for (const recipe of ['composer', 'mirror', 'fog', 'looks', 'bursts', 'timeline'] as const) {
  const tag = longIf(recipe !== 'composer');
  test(`the recipe ${recipe} shows the picture of the documentation${tag}`, async ({ load }, testInfo) => {
    const cases = await load<Recipes>('/tests/visual/three/recipes.cases.ts');
    const picture = await bytesOf(await cases.evaluateHandle((module, name) => module.pictureOf(name), recipe));
    expect(picture.length).toBeLessThan(LARGEST);
    await expectGolden(picture, { name: `../../../docs/images/${recipe}`, tolerance: 8, outliers: 40 }, testInfo);
  });
}
