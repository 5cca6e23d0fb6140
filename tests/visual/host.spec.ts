import { expect, test } from '../support/fixtures.ts';

type Cases = typeof import('./cases/host.ts');
const CASES = '/tests/visual/cases/host.ts';

for (const [antialias, toneMapped] of [
  [false, false],
  [true, true],
]) {
  const how = `${antialias ? 'smoothed' : 'plain'}, ${toneMapped ? 'tone-mapped' : 'not tone-mapped'}`;
  test(`beside smoke and its shadow a scene stays as it is, bit for bit: ${how}`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const census = await cases.evaluate((module, [a, b]) => module.lightAndShadow(a, b), [antialias, toneMapped]);
    expect(census.wrong).toBe(0);
    expect(census.between).toBeLessThan(antialias ? census.dark : 1);
    expect(census.dark).toBeGreaterThan(300);
    expect(census.lit).toBeGreaterThan(10_000);
  });
}

for (const kind of ['skinned', 'instanced'] as const) {
  test(`a ${kind} mesh stands among smoke as its triangles do`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const { changed, hidden, shown } = await cases.evaluate((module, which) => module.deformed(which), kind);
    expect(hidden).toBeGreaterThan(100);
    expect(shown).toBeGreaterThan(100);
    // The same triangles from another vertex shader may round a pixel of an edge differently.
    expect(changed).toBeLessThanOrEqual(4);
  });
}

for (const kind of ['pane', 'sprite'] as const) {
  test(`a ${kind} tints the smoke that it stands before, in part that within which it stands, and none behind`, async ({
    load,
  }) => {
    const cases = await load<Cases>(CASES);
    const { before, within, behind, wrong } = await cases.evaluate((module, which) => module.blended(which), kind);
    expect(before).toBe(1);
    expect(within).toBeGreaterThan(0.02);
    expect(within).toBeLessThan(0.95);
    expect(behind).toBe(0);
    expect(wrong).toBe(0);
  });
}

test('a renderer is left as it was found', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { before, after, changed, drawn } = await cases.evaluate((module) => module.stateAsFound());
  expect(after).toEqual(before);
  expect(drawn).toBeGreaterThan(1000);
  expect(changed).toBe(0);
});

test('two cameras see one smoke, each as if it were alone', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { left, right, between, sameState } = await cases.evaluate((module) => module.twoCameras());
  expect(between).toBeGreaterThan(1000);
  expect([left, right]).toEqual([0, 0]);
  expect(sameState).toBe(true);
});

for (const samples of [0, 4]) {
  test(`a linear half float target with ${samples} samples holds the same picture`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const { changed, smoke } = await cases.evaluate((module, count) => module.inTarget(count), samples);
    expect(smoke).toBeGreaterThan(1000);
    // What is blended along an edge is blended in linear light there, and display-encoded on the canvas.
    expect(changed).toBeLessThan(1200);
  });
}

test('a renderer with an output buffer of half floats shows the same picture', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  expect(await cases.evaluate((module) => module.inOutputBuffer())).toBeLessThan(500);
});

for (const kind of ['mesh', 'skinned', 'instanced'] as const) {
  test(`what a ${kind === 'mesh' ? 'closed' : kind} mesh casts is the scene without its key light`, async ({
    load,
  }) => {
    const cases = await load<Cases>(CASES);
    const { wrong, between, dark, lit } = await cases.evaluate((module, which) => module.casting(which), kind);
    expect([wrong, between]).toEqual([0, 0]);
    // The thinnest shadow is that of a bent post, some five pixels wide.
    expect(dark).toBeGreaterThan(120);
    expect(lit).toBeGreaterThan(15_000);
  });
}

test.describe('refusals', () => {
  test.use({ allowed: /stencil|depth/i });

  test('say what is wrong and what to do', async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const said = await cases.evaluate((module) => module.refusals());
    expect(said.stencil).toMatch(/^UnsupportedError: .*stencil: true/);
    expect(said.logarithmic).toMatch(/^UnsupportedError: .*without logarithmicDepthBuffer/);
    expect(said.reversed).toMatch(/^UnsupportedError: .*without reversedDepthBuffer/);
    expect(said.light).toMatch(/^ParameterError: keyLight cannot be HemisphereLight: .*DirectionalLight/);
    expect(said.preset).toMatch(/^ParameterError: preset cannot be lampp: it takes lamp, /);
    expect(said.value).toMatch(/^ParameterError: emission.rate cannot be -1: it takes a number from 0 to/);
    expect(said.fixed).toMatch(/^ParameterError: seed cannot be 2: .*creation/);
    expect(said.given).toMatch(/^ParameterError: light.azimuth cannot be 20: .*your scene/);
    expect(said.open).toMatch(/^ParameterError: cast cannot be Mesh: .*closed mesh.*proxies/);
    expect(said.physics).toMatch(/^UnsupportedError: .*physics/);
    expect(said.target).toMatch(/^UnsupportedError: .*stencilBuffer: true/);
    expect(said.array).toMatch(/^UnsupportedError: .*ArrayCamera/);
    expect(said.again).toBe('nothing');
    expect(said.disposed).toMatch(/^SimulatorError: .*disposed/);
  });
});
