/** Smoke in render targets without stencil. The recipes of docs/three.md are tests here. */
import { expect, longIf, test } from '../../support/fixtures.ts';

type Targets = typeof import('./targets.cases.ts');
type Composers = typeof import('./composers.cases.ts');
type FogCases = typeof import('./fog.cases.ts');
const COMPOSERS = '/tests/visual/three/composers.cases.ts';
const FOG = '/tests/visual/three/fog.cases.ts';
const TARGETS = '/tests/visual/three/targets.cases.ts';

for (const samples of [0, 4]) {
  const tag = longIf(samples > 0);
  test(`EffectComposer with ${samples} samples shows the picture of the canvas${tag}`, async ({ load }) => {
    const cases = await load<Targets>(TARGETS);
    const { census, difference, bare, distinct, errors } = await cases.evaluate(
      (module, count) => module.byComposer(count),
      samples,
    );
    expect(errors).toEqual([]);
    expect(census.lit).toBeGreaterThan(20_000);
    expect(census.dark).toBeGreaterThan(300);
    // An edge of an object in the shadow mixes three colours where the target has samples.
    expect(census.between).toBeLessThan(samples > 0 ? 80 : 1);
    expect(census.wrong).toBeLessThan(samples > 0 ? 5 : 1);
    // The edges of smoke are blended in linear light, but display-encoded on the canvas.
    expect(difference - bare).toBeLessThan(0.0005);
    expect(distinct).toBeLessThan(44);
  });
}

for (const samples of [0, 4]) {
  const tag = longIf(samples === 0);
  test(`the composer of pmndrs/postprocessing with ${samples} samples shows the picture of the canvas${tag}`, async ({
    load,
  }) => {
    const cases = await load<Composers>(COMPOSERS);
    const { difference, bare, smoke, errors } = await cases.evaluate(
      (module, count) => module.byPmndrs(count),
      samples,
    );
    expect(errors).toEqual([]);
    expect(smoke).toBeGreaterThan(2000);
    expect(bare).toBeLessThan(0.005);
    expect(difference - bare).toBeLessThan(0.0005);
  });
}

test('a renderer with an output buffer maps the tones of smoke as a composer does', async ({ load }) => {
  const cases = await load<Composers>(COMPOSERS);
  const { difference, bare, smoke, errors } = await cases.evaluate((module) => module.byOutputBuffer());
  expect(errors).toEqual([]);
  expect(smoke).toBeGreaterThan(2000);
  expect(difference - bare).toBeLessThan(0.0005);
});

// The operators of three.js by their numbers, and whether they have an inverse.
for (const [name, operator, isExact] of [
  ['no', 0, true],
  ['linear', 1, true],
  ['Reinhard', 2, true],
  ['Cineon', 3, true],
  ['Neutral', 7, true],
  ['ACES Filmic', 4, false],
  ['AgX', 6, false],
] as const) {
  test(`OutputPass shows smoke in ${isExact ? 'its' : 'other'} colours with ${name} tone mapping${longIf(!/no|AgX/.test(name))}`, async ({
    load,
  }) => {
    const cases = await load<Composers>(COMPOSERS);
    for (const exposure of isExact ? [1, 0.6, 1.5] : [1]) {
      const choice = { operator, exposure };
      const { gap, smoke } = await cases.evaluate(
        (module, given) => module.underToneMapping(given.operator, given.exposure),
        choice,
      );
      expect(smoke).toBeGreaterThan(4000);
      if (isExact) expect(gap, JSON.stringify(choice)).toBeLessThanOrEqual(2);
      else expect(gap).toBeGreaterThan(10);
    }
  });
}

test('a mirror shows smoke and its shadow, and keeps its picture where it is in the shadow itself', async ({
  load,
}) => {
  const cases = await load<Targets>(TARGETS);
  const { difference, distinct, smoke, black } = await cases.evaluate((module) => module.byMirror());
  expect(smoke).toBeGreaterThan(500);
  expect(difference).toBeLessThan(0.0002);
  expect(distinct).toBeLessThan(25);
  expect(black).toBe(0);
});

test('a face of a CubeCamera shows smoke and its shadow @long', async ({ load }) => {
  const cases = await load<Targets>(TARGETS);
  const { difference, distinct, smoke } = await cases.evaluate((module) => module.byCubeCamera());
  expect(smoke).toBeGreaterThan(2000);
  expect(difference).toBeLessThan(0.0006);
  expect(distinct).toBeLessThan(90);
});

test('passes that draw the scene with one material do not show smoke, so that it is not occluded', async ({ load }) => {
  const cases = await load<Targets>(TARGETS);
  const { normals, darkened, smoke } = await cases.evaluate((module) => module.byOcclusion());
  expect(normals).toBe(0);
  // What is near behind smoke is still darkened, as behind any transparent object.
  expect(darkened / smoke).toBeLessThan(0.05);
});

test('SSAOPass leaves smoke as it is @long', async ({ load }) => {
  const cases = await load<Composers>(COMPOSERS);
  const { darkened, smoke } = await cases.evaluate((module) => module.bySsao());
  expect(smoke).toBeGreaterThan(1000);
  expect(darkened / smoke).toBeLessThan(0.05);
});

test('BokehPass blurs smoke with what is behind it, and leaves it sharp in focus @long', async ({ load }) => {
  const cases = await load<Composers>(COMPOSERS);
  const { sharp, blurred, smoke } = await cases.evaluate((module) => module.byBokeh());
  expect(smoke).toBeGreaterThan(2000);
  expect(sharp).toBe(0);
  expect(blurred).toBeGreaterThan(2000);
});

test('bloom leaves white smoke as it is', async ({ load }) => {
  const cases = await load<Targets>(TARGETS);
  const { smoke, lamp } = await cases.evaluate((module) => module.byBloom());
  expect(smoke).toBe(0);
  expect(lamp).toBeGreaterThan(500);
});

for (const [kind, isComposed] of [
  ['linear', false],
  ['exponential', false],
  ['linear', true],
] as const) {
  const tag = longIf(kind === 'exponential');
  test(`${kind} fog takes smoke as far as its depth says, ${isComposed ? 'in a target' : 'on the canvas'}${tag}`, async ({
    load,
  }) => {
    const cases = await load<FogCases>(FOG);
    const { smoke, wrong, changed } = await cases.evaluate((module, [a, b]) => module.inFog(a, b), [
      kind,
      isComposed,
    ] as const);
    expect(smoke).toBeGreaterThan(900);
    expect(changed).toBe(smoke);
    expect(wrong).toBe(0);
  });
}

test.describe('the code for targets without stencil', () => {
  test.use({ ownPage: true, allowed: /ERR_FAILED/ });

  test('that fails to load is one error event, and complete() retries @long', async ({ load, blank }) => {
    const CODE = '**/src/three/target/ownStencil.ts*';
    const cases = await load<Targets>(TARGETS);
    await blank.route(CODE, (route) => route.abort());
    const smoking = await cases.evaluateHandle((module) => module.smokeWithoutStencil());
    const errors = () => smoking.evaluate((one) => one.errors);
    await expect.poll(errors).toEqual([expect.stringMatching(/^LoadError: .*without stencil could not be loaded/)]);
    const { dark, wrong } = await smoking.evaluate((one) => one.census());
    expect([dark, wrong]).toEqual([0, 0]);
    const thrown = await smoking.evaluate(({ smoke }) => smoke.complete().catch((error: Error) => error.name));
    expect(thrown).toBe('LoadError');
    expect((await errors()).length).toBe(1);
    await blank.unroute(CODE);
    await smoking.evaluate(({ smoke }) => smoke.complete());
    expect((await smoking.evaluate((one) => one.census())).dark).toBeGreaterThan(300);
  });
});
