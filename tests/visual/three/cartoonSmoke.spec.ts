import type { Page, Route } from '@playwright/test';
import { expect, longIf, test } from '../../support/fixtures.ts';

type Billboards = typeof import('./billboards.cases.ts');
type Ink = typeof import('./ink.cases.ts');
type Meshes = typeof import('./meshes.cases.ts');
type Output = typeof import('./output.cases.ts');
type Errors = typeof import('./errors.cases.ts');
type Hostile = typeof import('./hostile.cases.ts');
type Shadow = typeof import('./shadow.cases.ts');
const BILLBOARDS = '/tests/visual/three/billboards.cases.ts';
const INK = '/tests/visual/three/ink.cases.ts';
const MESHES = '/tests/visual/three/meshes.cases.ts';
const OUTPUT = '/tests/visual/three/output.cases.ts';
const ERRORS = '/tests/visual/three/errors.cases.ts';
const SHADOW = '/tests/visual/three/shadow.cases.ts';

for (const { antialias, toneMapped, reversedDepthBuffer } of [
  { antialias: false, toneMapped: false, reversedDepthBuffer: false },
  { antialias: true, toneMapped: true, reversedDepthBuffer: false },
  { antialias: false, toneMapped: false, reversedDepthBuffer: true },
]) {
  const how = [antialias && 'smoothed', toneMapped && 'tone-mapped', reversedDepthBuffer && 'depth reversed'];
  const tag = longIf(reversedDepthBuffer);
  test(`outside smoke and its shadow a scene is unchanged, bit for bit: ${how.filter(Boolean).join(', ') || 'plain'}${tag}`, async ({
    load,
  }) => {
    const cases = await load<Shadow>(SHADOW);
    const census = await cases.evaluate(
      (module, [parameters, isMapped]) => module.lightAndShadow(parameters, isMapped),
      [{ antialias, reversedDepthBuffer }, toneMapped] as const,
    );
    expect(census.wrong).toBe(0);
    expect(census.between).toBeLessThan(antialias ? census.dark : 1);
    expect(census.dark).toBeGreaterThan(300);
    expect(census.lit).toBeGreaterThan(10_000);
  });
}

for (const steps of [1, 2] as const) {
  test(`smoke has the shadow on itself that it has in a stage, with ${steps} steps of shadow`, async ({ load }) => {
    const cases = await load<Shadow>(SHADOW);
    const { shadowed, different } = await cases.evaluate(
      (module, count) => module.likeStage({ 'style.shadowSteps': count }),
      steps,
    );
    expect(shadowed).toBeGreaterThan(60);
    expect(different).toBeLessThanOrEqual(0.001 * 200 * 140);
  });
}

test('the stencil of a scene serves the shadow on its objects only', async ({ load }) => {
  const cases = await load<Shadow>(SHADOW);
  const { alone, above, beside } = await cases.evaluate((module) => module.stencilDraws());
  expect([alone, beside]).toEqual([0, 0]);
  expect(above).toBeGreaterThan(0);
});

for (const antialias of [false, true]) {
  test(`volumes begin and end where objects are, ${antialias ? 'counted' : 'by receiver'}`, async ({ load }) => {
    const cases = await load<Shadow>(SHADOW);
    const { different, dark } = await cases.evaluate((module, is) => module.longVolumes({ antialias: is }), antialias);
    expect(dark).toBeGreaterThan(100);
    expect(different).toBe(0);
  });
}

test('an invisible box shadows the objects behind it', async ({ load }) => {
  const cases = await load<Shadow>(SHADOW);
  const { wrong, between, dark, lit } = await cases.evaluate((module) => module.meshShadow());
  expect([wrong, between]).toEqual([0, 0]);
  expect(dark).toBeGreaterThan(300);
  expect(lit).toBeGreaterThan(15_000);
});

test('proxy balls and capsules cast the shadow that ray casting finds', async ({ load }) => {
  const cases = await load<Shadow>(SHADOW);
  for (const [kind, isNear] of [
    ['capsules', false],
    ['bones', false],
    ['instances', false],
    ['capsules', true],
  ] as const) {
    const { dark, lit, wrong } = await cases.evaluate((module, input) => module.ballShadow(...input), [
      kind,
      isNear,
    ] as const);
    expect(wrong, kind).toBe(0);
    expect(dark, kind).toBeGreaterThan(60);
    expect(lit, kind).toBeGreaterThan(10_000);
  }
});

test('all casters together count as one step of shadow, and smoke as the second', async ({ load }) => {
  const cases = await load<Shadow>(SHADOW);
  const { byBoxes, byBoth, bySmoke, wrong } = await cases.evaluate((module) => module.deepShadow());
  expect(wrong).toBe(0);
  expect(byBoxes, 'in the shadow of both boxes').toBeGreaterThan(200);
  expect(byBoth, 'in that of one puff and of a box').toBeGreaterThan(100);
  expect(bySmoke, 'in that of puffs').toBeGreaterThan(100);
});

for (const [antialias, origin] of [
  [false, 0],
  [false, 20],
  [true, 20],
] as const) {
  const where = `${origin > 0 ? 'in a part of ' : 'on '}a ${antialias ? 'smoothed' : 'plain'} canvas`;
  test(`ink closes where smoke enters the host's floor, ${where}`, async ({ load }) => {
    const cases = await load<Ink>(INK);
    const { border, inked } = await cases.evaluate((module, [a, b]) => module.contactLine(a, b), [
      antialias,
      origin,
    ] as const);
    expect(border).toBeGreaterThan(120);
    expect(inked / border).toBeGreaterThan(0.99);
  });
}

test('lines boil between drawings', async ({ load }) => {
  const cases = await load<Ink>(INK);
  const { boiling, steady } = await cases.evaluate((module) => module.boiling());
  expect(boiling).toBeGreaterThan(steady + 100);
});

for (const kind of ['skinned', 'instanced'] as const) {
  test(`a ${kind} mesh occludes smoke where its triangles are`, async ({ load }) => {
    const cases = await load<Meshes>(MESHES);
    const { changed, hidden, shown } = await cases.evaluate((module, which) => module.deformed(which), kind);
    expect(hidden).toBeGreaterThan(100);
    expect(shown).toBeGreaterThan(100);
    // Another vertex shader may round an edge pixel of the same triangles differently.
    expect(changed).toBeLessThanOrEqual(4);
  });
}

for (const kind of ['pane', 'sprite'] as const) {
  test(`a ${kind} tints the smoke behind it, part of the smoke around it, and none in front`, async ({ load }) => {
    const cases = await load<Meshes>(MESHES);
    const { before, within, behind, wrong } = await cases.evaluate((module, which) => module.blended(which), kind);
    expect(before).toBe(1);
    expect(within).toBeGreaterThan(0.02);
    expect(within).toBeLessThan(0.95);
    expect(behind).toBe(0);
    expect(wrong).toBe(0);
  });
}

for (const place of ['canvas', 'target'] as const) {
  test(`the state of the renderer is restored: ${place}${longIf(place === 'target')}`, async ({ load }) => {
    const cases = await load<Output>(OUTPUT);
    const { before, after, changed, drawn } = await cases.evaluate(
      (module, where) => module.stateAsFound(where),
      place,
    );
    expect(after).toEqual(before);
    expect(drawn).toBeGreaterThan(1000);
    expect(changed).toBe(0);
  });
}

test('two smokes hide each other and both shadow the scene, but do not shade each other', async ({ load }) => {
  const cases = await load<Output>(OUTPUT);
  const { lower, changed, shadow, wrong } = await cases.evaluate((module) => module.twoSmokes());
  expect(lower).toBeGreaterThan(500);
  expect(changed).toBe(0);
  expect(shadow).toBeGreaterThan(300);
  expect(wrong).toBe(0);
});

test('two cameras draw the same smoke independently', async ({ load }) => {
  const cases = await load<Output>(OUTPUT);
  const { left, right, between, sameState } = await cases.evaluate((module) => module.twoCameras());
  expect(between).toBeGreaterThan(1000);
  expect([left, right]).toEqual([0, 0]);
  expect(sameState).toBe(true);
});

for (const samples of [0, 4]) {
  test(`a linear half float target with ${samples} samples holds the same picture${longIf(samples === 0)}`, async ({
    load,
  }) => {
    const cases = await load<Output>(OUTPUT);
    const { changed, smoke } = await cases.evaluate((module, count) => module.inTarget(count), samples);
    expect(smoke).toBeGreaterThan(1000);
    // Edges are blended in linear light in the target, but display-encoded on the canvas.
    expect(changed).toBeLessThan(1200);
  });
}

for (const kind of ['rigid', 'bones', 'instances', 'proxies'] as const) {
  const tag = longIf(kind === 'instances' || kind === 'proxies');
  test(`objects that are hidden or not in the scene cast no shadow: ${kind}${tag}`, async ({ load }) => {
    const cases = await load<Shadow>(SHADOW);
    const { there, back, ...gone } = await cases.evaluate((module, which) => module.shadowsOfGone(which), kind);
    expect(there).toBeGreaterThan(100);
    expect(gone).toEqual({ hidden: 0, inHidden: 0, removed: 0 });
    expect(back).toBe(there);
  });
}

for (const [kind, most] of [
  ['outputBuffer', 500],
  ['reversedDepth', 20],
] as const) {
  test(`a renderer with ${kind} shows the same picture${longIf(kind === 'outputBuffer')}`, async ({ load }) => {
    const cases = await load<Output>(OUTPUT);
    expect(await cases.evaluate((module, which) => module.otherRenderer(which), kind)).toBeLessThan(most);
  });
}

test.describe('errors', () => {
  test.use({ allowed: /stencil|depth/i });

  test('report the cause and the solution', async ({ load }) => {
    const cases = await load<Errors>(ERRORS);
    const said = await cases.evaluate((module) => module.errors());
    expect(said.stencil).toMatch(/^UnsupportedError: .*stencil: true/);
    expect(said.logarithmic).toMatch(/^UnsupportedError: .*without logarithmicDepthBuffer/);
    expect(said.light).toMatch(/^ParameterError: keyLight cannot be “HemisphereLight”: .*DirectionalLight/);
    expect(said.preset).toMatch(/^ParameterError: preset cannot be “lampp”: it takes the name of a preset/);
    expect(said.value).toMatch(/^ParameterError: emission.rate cannot be -1: it takes a number from 0 to/);
    expect(said.fixed).toMatch(/^ParameterError: seed cannot be 2: .*creation/);
    expect(said.given).toMatch(/^ParameterError: light.azimuth cannot be 20: .*your scene/);
    expect(said.open).toMatch(/^ParameterError: cast cannot be “Mesh”: .*closed mesh.*proxies/);
    expect(said.empty).toMatch(/^ParameterError: cast cannot be “Group”: .*contains a mesh/);
    expect(said.emitter).toMatch(/^ParameterError: emitter cannot be 8: it takes a whole number from 0 to 7/);
    expect(said.clone).toMatch(/^UnsupportedError: .*cloned.*create/);
    expect(said.json).toMatch(/^UnsupportedError: .*JSON: keep its values/);
    expect(said.seconds).toMatch(/^ParameterError: seconds cannot be NaN/);
    expect(said.count).toMatch(/^ParameterError: count cannot be NaN/);
    expect(said.fraction).toMatch(/^ParameterError: count cannot be 1.5: it takes a whole number from 0/);
    expect(said.afterwards).toBe('nothing');
    expect(said.physics).toMatch(/^UnsupportedError: .*physics/);
    expect(said.target).toMatch(/^UnsupportedError: .*several textures/);
    expect(said.array).toMatch(/^UnsupportedError: .*ArrayCamera/);
    expect(said.viewport).toMatch(/^UnsupportedError: .*viewport of 1000000 x 50 pixels/);
    expect(said.repeated).toBe('nothing');
    expect(said.again).toBe('nothing');
    expect(said.session).toMatch(/^UnsupportedError: .*XR session/);
    expect(said.sessionAgain).toBe('nothing');
    expect(said.call).toMatch(/^SimulatorError: .*disposed/);
    expect(said.disposed).toMatch(/^SimulatorError: .*disposed/);
  });
});

test.describe('mistakes of a page', () => {
  // three.js warns of attributes that are missing, WebGL of sizes.
  test.use({ allowed: /THREE|GL_INVALID/ });

  test('never make update or a render throw, and nothing is lost', async ({ load }) => {
    const cases = await load<Hostile>('/tests/visual/three/hostile.cases.ts');
    const seen = await cases.evaluate((module) => module.survive(1, 100));
    expect(seen.thrown).toEqual([]);
    expect(seen.foreign).toEqual([]);
    expect(seen.unclear).toEqual([]);
    expect(seen.renders).toBeGreaterThan(50);
    expect(seen.smoke).toBeGreaterThan(500);
    expect(seen.shadow).toBeGreaterThan(50);
  });
});

test.describe('billboards that are not loaded yet', () => {
  test.use({ ownPage: true, allowed: /ERR_FAILED/ });

  const CODE = '**/src/renderer/billboards.ts*';
  const block = (page: Page) => page.route(CODE, (route) => route.abort());
  /** The intercepted request, held until the test continues it. */
  const held = async (page: Page) => {
    let take!: (route: Route) => void;
    const asked = new Promise<Route>((resolve) => (take = resolve));
    await page.route(CODE, take);
    return { asked };
  };

  test('lobes are drawn while the code loads; billboards then equal those loaded at the start', async ({
    load,
    blank,
  }) => {
    const cases = await load<Billboards>(BILLBOARDS);
    const request = await held(blank);
    const asked = await cases.evaluateHandle((module) => module.ask());
    const route = await request.asked;
    expect(await cases.evaluate((module, one) => module.frames(one), asked)).toBe(0);
    await route.continue();
    await asked.evaluate(({ smoke }) => smoke.complete());
    expect(await cases.evaluate((module, one) => module.frames(one), asked)).toBeGreaterThan(100);
    expect(await cases.evaluate((module, one) => module.fromStart(one), asked)).toBe(0);
    expect(await asked.evaluate(({ notified }) => notified)).toEqual([]);
  });

  test('a failed load keeps lobes, emits one error event, throws in no frame, and can be retried @long', async ({
    load,
    blank,
  }) => {
    const cases = await load<Billboards>(BILLBOARDS);
    await block(blank);
    const asked = await cases.evaluateHandle((module) => module.ask());
    const notified = () => asked.evaluate((one) => one.notified);
    const once = [expect.stringMatching(/^LoadError: Billboards could not be loaded/)];
    await expect.poll(notified).toEqual(once);
    expect(await cases.evaluate((module, one) => module.frames(one), asked)).toBe(0);
    const thrown = await asked.evaluate(({ smoke }) => smoke.complete().catch((error: Error) => error.name));
    expect(thrown).toBe('LoadError');
    // Each frame had time to retry and to notify: complete() waited as long.
    expect(await notified()).toEqual(once);
    await asked.evaluate(({ smoke }) => {
      smoke.set({ 'puff.form': 'lobes' });
      smoke.set({ 'puff.form': 'billboards' });
    });
    await expect.poll(notified).toEqual([...once, ...once]);
    await blank.unroute(CODE);
    await asked.evaluate(({ smoke }) => smoke.complete());
    expect(await cases.evaluate((module, one) => module.frames(one), asked)).toBeGreaterThan(100);
  });

  test('setPuffs draws a drawing like its parameter, rejects no shapes, and gives way to the values', async ({
    load,
  }) => {
    const cases = await load<Billboards>(BILLBOARDS);
    const { byLobes, ...found } = await cases.evaluate((module) => module.setPuffs());
    const error = 'ShapeError: Smoke cannot have 0 puff shapes: use 1 to 32.';
    expect(found).toEqual({ own: 0, error, afterError: 0, restored: 0 });
    expect(byLobes).toBeGreaterThan(100);
  });

  test('code that is no longer needed causes no error, and creation waits for needed code @long', async ({
    load,
    blank,
  }) => {
    const cases = await load<Billboards>(BILLBOARDS);
    const request = await held(blank);
    const asked = await cases.evaluateHandle((module) => module.ask());
    const route = await request.asked;
    await asked.evaluate(({ smoke }) => smoke.set({ 'puff.form': 'lobes' }));
    await block(blank);
    await route.abort();
    expect(await cases.evaluate((module) => module.beginWith())).toBe('LoadError');
    expect(await asked.evaluate(({ notified }) => notified)).toEqual([]);
  });
});
