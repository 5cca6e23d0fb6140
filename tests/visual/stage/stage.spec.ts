import { expect, longIf, test } from '../../support/fixtures.ts';
import { bytesOf, expectGolden } from '../../support/goldens.ts';
import { expectGone } from './ends.ts';

type Pictures = typeof import('./stage.cases.ts');
type Backlog = typeof import('./backlog.cases.ts');
type Devices = typeof import('./devices.cases.ts');
type Quality = typeof import('./quality.cases.ts');
type Errors = typeof import('./errors.cases.ts');
type Renderers = typeof import('./renderers.cases.ts');
type Times = typeof import('./times.cases.ts');

const PICTURES = '/tests/visual/stage/stage.cases.ts';
const BACKLOG = '/tests/visual/stage/backlog.cases.ts';
const DEVICES = '/tests/visual/stage/devices.cases.ts';
const QUALITY = '/tests/visual/stage/quality.cases.ts';
const ERRORS = '/tests/visual/stage/errors.cases.ts';
const RENDERERS = '/tests/visual/stage/renderers.cases.ts';
const TIMES = '/tests/visual/stage/times.cases.ts';

for (const seconds of [1, 3, 6]) {
  test(`the lamp after ${seconds} s${longIf(seconds === 3)}`, async ({ load }, testInfo) => {
    const cases = await load<Pictures>(PICTURES);
    const picture = await cases.evaluateHandle((module, time) => module.lampPicture(time), seconds);
    const { colors, commonest, pixels } = await cases.evaluate((module, blob) => module.census(blob), picture);
    expect(colors).toBeGreaterThan(50);
    expect(commonest / pixels).toBeLessThan(0.5);
    await expectGolden(await bytesOf(picture), { name: `lamp-${seconds}s`, tolerance: 6, outliers: 40 }, testInfo);
  });
}

test('a hidden stage has no render targets, and its next picture is the same', async ({ load }) => {
  const cases = await load<Pictures>(PICTURES);
  const { textures, differing } = await cases.evaluate((module) => module.hiddenStage());
  const [visible, hidden, again] = textures;
  expect(visible - hidden).toBeGreaterThan(4);
  expect(again).toBe(visible);
  expect(differing).toBe(0);
});

test('two stages share a device and draw their own pictures', async ({ load }) => {
  const cases = await load<Devices>(DEVICES);
  const report = await cases.evaluate((module) => module.shareDevice());
  expect(report.between).toBeGreaterThan(1000);
  expect(report.firstAlone).toBe(0);
  expect(report.secondAlone).toBe(0);
  expect(await cases.evaluate((module) => module.sharedCanvases())).toBeGreaterThan(1000);
});

for (const which of ['halfQuality', 'halfQualityShared'] as const) {
  const tag = longIf(which === 'halfQuality');
  test(`a lower quality keeps the canvas size, the flat tones and the ink width: ${which}${tag}`, async ({ load }) => {
    const cases = await load<Quality>(QUALITY);
    const report = await cases.evaluate((module, name) => module[name](), which);
    expect(report.flat).toBeGreaterThan(2_000);
    expect(report.ink).toBeGreaterThan(50);
    expect(report.differing).toBe(0);
    expect(report.pictureChanged).toBe(0);
    expect(report.canvas).toEqual([320, 240]);
  });
}

test('quality auto draws fewer pixels on a slow machine, and all of them while paused', async ({ load }) => {
  const cases = await load<Quality>(QUALITY);
  expect(await cases.evaluate((module) => module.governedScales('auto'))).toEqual({ played: [1, 0.59], paused: 1 });
  expect(await cases.evaluate((module) => module.governedScales(undefined))).toEqual({ played: [1], paused: 1 });
});

test('frames do not queue up on a slow GPU, even if the canvas is not visible', async ({ load }) => {
  const cases = await load<Backlog>(BACKLOG);
  expect(await cases.evaluate((module) => module.maxInFlight(12))).toBeLessThanOrEqual(2);
});

test('drawing continues when WASM memory grows', async ({ load }) => {
  const cases = await load<Devices>(DEVICES);
  const report = await cases.evaluate((module) => module.growMemory());
  expect(report.grown).toBe(true);
  expect(report.painted).toBeGreaterThan(50);
  expect(report.changed).toBe(0);
});

test.describe('loss', () => {
  test.use({ allowed: /context lost|context restored|CONTEXT_LOST/i, ownPage: true });

  test('a restored context continues the simulation unchanged', async ({ load }) => {
    const cases = await load<Devices>(DEVICES);
    const report = await cases.evaluate((module) => module.loseContext());
    expect(report).toEqual({ changed: 0, sameHash: true, rejected: true });
  });

  // More than the browser's limit of sixteen live contexts.
  test('a canvas of a disposed stage is rejected with a message', async ({ load }) => {
    const cases = await load<Devices>(DEVICES);
    expect(await cases.evaluate((module) => module.useCanvasAgain())).toMatch(/^ContextError: .*use another canvas/);
  });

  test('40 stages leave no live context and no object @long', async ({ load, blank }) => {
    await expectGone(load, blank, 40);
  });
});

for (const speed of [1, 0.5, 0.25]) {
  test(`at speed ${speed} on a 60 Hz clock frames are ${speed} steps apart`, async ({ load }) => {
    const cases = await load<Times>(TIMES);
    expect(await cases.evaluate((module, value) => module.movementAtSpeed(value), speed)).toBeLessThan(0.02);
  });
}

test('a take on another stage has the same hashes and the same picture @long', async ({ load }) => {
  const cases = await load<Times>(TIMES);
  const { hashes, rates, inputs, changed } = await cases.evaluate((module) => module.replayTake());
  expect(hashes[1]).toBe(hashes[0]);
  expect(rates).toEqual([rates[0], rates[0], 60]);
  // Rate, nudge, blow, steer, and the release by the spring after the nudge.
  expect(inputs).toEqual([5, 5]);
  expect(changed).toBe(0);
});

test('seeking back and forth reaches the same states, with all user input', async ({ load }) => {
  const cases = await load<Times>(TIMES);
  const { straight, again, bytes, rates } = await cases.evaluate((module) => module.seekBack());
  expect(again).toEqual(straight);
  expect(rates).toEqual([40, 80, 120, 160]);
  expect(bytes).toBeGreaterThan(0);
  expect(bytes).toBeLessThanOrEqual(1_000_000);
});

test('values that are not numbers are rejected by name and change nothing', async ({ load }) => {
  const cases = await load<Errors>(ERRORS);
  const { notified, wanted, ...after } = await cases.evaluate((module) => module.rejectNaN());
  expect(notified).toEqual(wanted);
  expect(after).toEqual({ isSame: true, errors: 0, isDrawn: true });
});

test('a seek with an aborted signal does not move and rejects with the reason', async ({ load }) => {
  const cases = await load<Errors>(ERRORS);
  const { steps, reasons } = await cases.evaluate((module) => module.seekCalledOff());
  expect(steps).toEqual([70, 70, 70]);
  expect(reasons).toHaveLength(3);
  expect(reasons[0]).toBe('not to 0.5 s');
});

test('the scene air has the same size in CSS pixels at every pixel ratio', async ({ load }) => {
  const cases = await load<Pictures>(PICTURES);
  for (const metres of await cases.evaluate((module) => module.airPerPixel())) expect(metres).toBeCloseTo(1 / 150, 6);
});

test('a stage draws neither invisible frames nor the same frame twice', async ({ load }) => {
  const cases = await load<Pictures>(PICTURES);
  expect(await cases.evaluate((module) => module.picturesDrawn())).toEqual([0, 1, 1, 2]);
});

test.describe('a renderer that is not loaded yet', () => {
  test.use({ ownPage: true, allowed: /ERR_FAILED/ });

  test('nailboards are drawn while the code loads; the renderer then equals one loaded at the start @long', async ({
    load,
  }) => {
    const cases = await load<Renderers>(RENDERERS);
    const { atOnce, later, fromStart } = await cases.evaluate((module) => module.lateRenderer());
    expect(atOnce).toBe(0);
    expect(later).toBeGreaterThan(100);
    expect(fromStart).toBe(0);
  });

  test('a failed load emits an error event, and nailboards are drawn', async ({ load, blank }) => {
    const cases = await load<Renderers>(RENDERERS);
    await blank.route('**/src/renderer/passes/selle.ts*', (route) => route.abort());
    const { notified, thrown, steps, drawn } = await cases.evaluate((module) => module.lostRenderer());
    expect(notified[0]).toContain('LoadError: The renderer selle could not be loaded');
    expect(thrown).toBe('LoadError');
    expect(steps).toBe(60);
    expect(drawn).toBeGreaterThan(0);
  });
});
