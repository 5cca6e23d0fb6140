import type { Values } from '../../../../src/parameters/parameter.ts';
import { expect, test } from '../../../support/fixtures.ts';

type Cases = typeof import('./shapes.cases.ts');
const CASES = '/tests/visual/renderer/puffs/shapes.cases.ts';

test('a lone puff masks none of its own lit pixels, whatever its shape', async ({ load }) => {
  const cases = await load<typeof import('../passes/lonePuffs.cases.ts')>(
    '/tests/visual/renderer/passes/lonePuffs.cases.ts',
  );
  const shapes = await (await load<Cases>(CASES)).evaluate((module) => module.oddShapes());
  const report = await cases.evaluate((module, odd) => module.selfMasked('lobes', 'sun', 200, odd), shapes);
  expect(report.lit).toBeGreaterThan(50_000);
  expect(report.masked).toBe(0);
});

test('smokes on one device have separate puffs, and all of them are released', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const report = await cases.evaluate((module) => module.shareDevice());
  expect(report.between).toBeGreaterThan(500);
  expect(report.disturbed).toBe(0);
  expect(report.same).toBe(0);
  expect(report.held).toEqual([2, 2, 1, 0]);
});

const CHANGED: readonly Values[] = [
  { 'puff.lumpiness': 0.1, 'puff.flatness': 1 },
  { 'puff.seed': 12, 'puff.lobes': 6 },
];

for (const values of CHANGED) {
  test(`knobs change a still picture to that of a new stage, and back: ${Object.keys(values).join()} @long`, async ({
    load,
  }) => {
    const cases = await load<Cases>(CASES);
    const report = await cases.evaluate((module, given) => module.changeKnobs(given), values);
    expect(report.changed).toBeGreaterThan(100);
    expect(report.asMade).toBe(0);
    expect(report.back).toBe(0);
  });
}

test('a particle keeps its variation for life', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const report = await cases.evaluate((module) => module.fewerVariations());
  expect(report).toEqual({ atOnce: 0, restored: 0, later: true });
});

test('a custom shape is drawn in both forms, can be removed, and is not part of the state', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const report = await cases.evaluate((module) => module.bringShape());
  expect(report.lobes).toBeGreaterThan(200);
  expect(report.billboards).toBeGreaterThan(200);
  expect(report.back).toBe(0);
  expect(report.hash).toBe(true);
});

test('8 bits in place of half floats move only seams and borders of light on billboards', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const { changed, back } = await cases.evaluate((module) => module.changePrecision());
  expect(changed).toBeGreaterThan(10);
  expect(changed).toBeLessThan(200);
  expect(back).toBe(0);
});

test('new puffs are baked in pieces while smoke plays', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const report = await cases.evaluate((module) => module.changeWhilePlaying());
  console.log('a knob turns while smoke plays:', report);
  expect(report.frames).toBeGreaterThan(3);
  expect(report.frames).toBeLessThan(200);
  expect(report.leftOver).toBe(0);
});
