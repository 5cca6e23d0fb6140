import { expect, longIf, test } from '../../../support/fixtures.ts';

type Smoke = typeof import('./smoke.cases.ts');
const SMOKE = '/tests/visual/three/fiber/smoke.cases.ts';

for (const isStrict of [false, true]) {
  test(`components do what calls do${isStrict ? ', also in StrictMode' : ''}${longIf(!isStrict)}`, async ({ load }) => {
    const cases = await load<Smoke>(SMOKE);
    const { byTree, byCalls, refs, gone, alive, isSamePicture } = await cases.evaluate(
      (module, strict) => module.besideCalls(strict),
      isStrict,
    );
    expect(byTree).toEqual(byCalls);
    expect(new Set(byTree).size).toBe(6);
    expect(alive).toBeGreaterThan(100);
    expect(isSamePicture).toBe(true);
    // The reference gives the smoke, and there is one although StrictMode mounts twice.
    expect(refs).toEqual([true, 1, 1, isStrict ? 2 : 1]);
    expect(gone).toEqual([null, null, 1]);
  });
}

test('the placement of a smoke moves it, without creating it again', async ({ load }) => {
  const cases = await load<Smoke>(SMOKE);
  const [seen, expected] = await cases.evaluate((module) => module.placed());
  expect(seen).toEqual(expected);
});

test('unmounting leaves no handle and no object on the GPU', async ({ load }) => {
  const cases = await load<Smoke>(SMOKE);
  const { seen, errors, isOut } = await cases.evaluate((module) => module.unmounted());
  const [before, during, after] = seen;
  expect(during.Texture).toBeGreaterThan(before.Texture);
  expect(after).toEqual(before);
  expect(isOut).toBe(true);
  expect(errors).toEqual([
    'SimulatorError: This smoke was disposed; create a new one.',
    expect.stringContaining('emitFrom.burst: this handle was removed'),
  ]);
});

test('emitters come and go, more than there can be at a time @long', async ({ load }) => {
  const cases = await load<Smoke>(SMOKE);
  const { errors, grown } = await cases.evaluate((module) => module.manyEmitters());
  expect(errors).toEqual([]);
  expect(grown).toEqual([20, 0]);
});

test('a smoke that is unmounted while it is created is disposed, and a fixed option creates another', async ({
  load,
}) => {
  const cases = await load<Smoke>(SMOKE);
  const { abandoned, puffs, ...second } = await cases.evaluate((module) => module.recreated());
  expect(abandoned).toEqual([1, 0]);
  expect(second).toEqual({ isNew: true, alive: 1 });
  expect(puffs).toBe(43);
});

test('smoke sees where objects are in the same frame, also those of components that come later', async ({ load }) => {
  const cases = await load<Smoke>(SMOKE);
  const [, ...seen] = await cases.evaluate((module) => module.order());
  expect(seen).toHaveLength(3);
  for (const [moved, placed] of seen) expect(placed).toBe(moved);
});

test('smoke without a key light uses the first directional light, and names props that it does not know', async ({
  load,
}) => {
  const cases = await load<Smoke>(SMOKE);
  const { used, said } = await cases.evaluate((module) => module.lights());
  expect(used).toEqual(['first', '']);
  expect(said).toEqual([
    expect.stringMatching(/^keyLight cannot be undefined: it takes a light .* no directional light/),
    expect.stringMatching(/^Smoke.keylight cannot be .*: it takes no value: its options are keyLight, /),
    expect.stringMatching(/^Smoke.renderOrder cannot be 3: /),
  ]);
});

test.describe('errors', () => {
  // React writes errors that reach a boundary.
  test.use({ allowed: /Emitter|sped/ });

  test('reach onError, or the error boundary', async ({ load }) => {
    const cases = await load<Smoke>(SMOKE);
    const { reported, caught } = await cases.evaluate((module) => module.mistakes());
    expect(reported).toEqual([
      expect.stringContaining('emitFrom.sped cannot be 3'),
      expect.stringContaining('emitFrom.rate cannot be -5'),
      expect.stringContaining('puff.size cannot be -1'),
      expect.stringContaining('seconds cannot be NaN'),
      expect.stringContaining('stencil'),
    ]);
    expect(caught).toEqual([
      '<Emitter> works inside <Smoke> only: put it among its children.',
      expect.stringContaining('emitFrom.sped cannot be 3'),
    ]);
  });
});
