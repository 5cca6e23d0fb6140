import { beforeAll, expect, test } from 'vitest';
import type { Values } from '../../../src/parameters/parameter.ts';
import { defaultPreset, presetValues } from '../../../src/parameters/presets.ts';
import { fetchExtras } from '../../../src/renderer/extraPasses.ts';
import { LivePuffs } from '../../../src/renderer/livePuffs.ts';

const ONE: Values = { ...presetValues(defaultPreset), 'puff.variations': 1 };
/** A non-default value of each row that affects the shape of puffs. */
const CHANGED: readonly (readonly [key: string, value: number])[] = [
  ['puff.lumpiness', 0.2],
  ['puff.flatness', 0.9],
  ['puff.roughness', 0.1],
  ['puff.lobes', 6],
  ['puff.seed', 9],
];

const LOOKS: readonly Values[] = [{ 'puff.form': 'billboards' }, { 'style.renderer': 'selle' }];

beforeAll(async () => {
  const kind = {
    renderer: 'selle',
    isDeformed: false,
    volumes: 'receiver',
    simplify: 0,
    plumeForm: 0,
    outlines: true,
    strokes: 0,
    isEroded: false,
  } as const;
  await Promise.all((['billboards', 'lobes'] as const).map((form) => fetchExtras({ ...kind, form })));
});

function layersOf(values: Values) {
  return new LivePuffs({ ...ONE, ...values }).finish()!.billboards.layers;
}

test.each(CHANGED)('billboards, and so the puffs of Selle, take their shapes from %s', (key, value) => {
  const [before, after] = [layersOf({}), layersOf({ [key]: value })];
  // Normals and heights inside, and the silhouette.
  const changed = (name: 'normalDepth' | 'colorCoverage') =>
    [...before[name]].filter((word, at) => word !== after[name][at]).length;
  expect(changed('normalDepth')).toBeGreaterThan(5_000);
  expect(changed('colorCoverage')).toBeGreaterThan(1_000);
});

test('there are as many billboards as variations, all different', () => {
  const { count, normalDepth } = layersOf({ 'puff.variations': 5 });
  expect(count).toBe(5);
  const words = normalDepth.length / count;
  const layers = Array.from({ length: count }, (_, layer) => normalDepth.subarray(layer * words, (layer + 1) * words));
  expect(new Set(layers.map((layer) => layer.join())).size).toBe(5);
});

function pieces(values: Values): number {
  const puffs = new LivePuffs({ ...ONE, ...values });
  let count = 0;
  while (!puffs.workFor(0)) count++;
  return count;
}

test.each(LOOKS)('they are baked in pieces if %o shows them, and only then', (look) => {
  const seed = look['puff.form'] ? 51 : 52;
  const lobes = pieces({ 'puff.seed': seed });
  expect(lobes).toBeGreaterThan(10);
  // Lobes with this seed are cached; only billboards are missing.
  expect(pieces({ 'puff.seed': seed, ...look })).toBeGreaterThan(30);
  expect(pieces({ 'puff.seed': seed })).toBe(0);
});

test('start caps are baked for lobes that do not turn, stretch or unfold, and only for them', () => {
  const still = { 'puff.turn': 0, 'puff.stretch': 1, 'puff.billow': 0, 'emission.dissolve': 'shrink' } as const;
  const moving = ['puff.turn', 'puff.stretch', 'puff.billow'].map((key) =>
    pieces({ ...still, [key]: 1.5, 'puff.seed': 61 }),
  );
  expect(moving[0]).toBeLessThan(20);
  expect(moving.slice(1)).toEqual([0, 0]);
  // Of the same puffs only the start caps are missing now.
  expect(pieces({ ...still, 'puff.seed': 61 })).toBeGreaterThan(30);
});
