import { expect, test } from '../../../support/fixtures.ts';

type Views = typeof import('./views.cases.ts');
const VIEWS = '/tests/visual/three/target/views.cases.ts';

for (const kind of ['views', 'mirrors'] as const) {
  test(`cameras with the same product of matrices show the same smoke: ${kind}`, async ({ load }) => {
    const cases = await load<Views>(VIEWS);
    const seen = await cases.evaluate((module, which) => module[which](), kind);
    expect(seen.filter(({ changed, errors, smoke }) => changed > 10 || smoke < 1500 || errors.length > 0)).toEqual([]);
  });
}
