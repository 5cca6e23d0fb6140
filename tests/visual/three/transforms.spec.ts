import { expect, longIf, test } from '../../support/fixtures.ts';

type Transforms = typeof import('./transforms.cases.ts');
const TRANSFORMS = '/tests/visual/three/transforms.cases.ts';

for (const kind of ['perspective', 'orthographic'] as const) {
  const tag = longIf(kind === 'orthographic');
  test(`local smoke that moves with the scene gives the same picture, ${kind}${tag}`, async ({ load }) => {
    const cases = await load<Transforms>(TRANSFORMS);
    const seen = await cases.evaluate((module, given) => module.together(given), kind);
    expect(seen.without).toBeGreaterThan(2000);
    expect(seen.rotated).toBeGreaterThan(300);
    // Of 28,000 pixels: an edge may fall to the other side of a sample.
    expect(seen.moved).toBeLessThan(10);
  });
}

test('smoke in a turned and scaled parent changes no pixel beside itself', async ({ load }) => {
  const cases = await load<Transforms>(TRANSFORMS);
  const { outside, inside } = await cases.evaluate((module) => module.beside());
  expect(outside).toBe(0);
  expect(inside).toBeGreaterThan(500);
});

test('local smoke and its shadow on the floor are where the object and the light place them', async ({ load }) => {
  const cases = await load<Transforms>(TRANSFORMS);
  const seen = await cases.evaluate((module) => module.places());
  for (const { smoke, shadow } of seen) {
    expect(smoke).toBeLessThan(2);
    expect(shadow).toBeLessThan(4);
  }
});

test('an invalid transform is one error event, and the smoke stays', async ({ load }) => {
  const cases = await load<Transforms>(TRANSFORMS);
  const { said, changed, alive } = await cases.evaluate((module) => module.invalid());
  expect(said).toEqual([
    expect.stringMatching(/^ParameterError: smoke\.transform cannot be “CartoonSmoke at NaN/),
    expect.stringMatching(/^ParameterError: smoke\.transform cannot be “CartoonSmoke at .* with the scale 1, 2, 1”/),
  ]);
  expect(changed).toEqual([0, 0]);
  expect(new Set(alive).size).toBe(1);
});

test('a scale that changes between update and render leaves the shadows of objects as they are', async ({ load }) => {
  const cases = await load<Transforms>(TRANSFORMS);
  const { changed, shadow } = await cases.evaluate((module) => module.rescaled());
  expect(shadow).toBeGreaterThan(100);
  expect(changed).toBeLessThan(5);
});
