import { expect, test } from 'vitest';
import { bakeLobes } from '../../../../src/renderer/puffs/bake/bakeLobes.ts';
import { meetLobes, reachOf, silhouetteRadius } from '../../../../src/renderer/puffs/lobes.ts';
import { sampleLobes } from '../../../../src/renderer/puffs/billboards/channelSheet.ts';
import { DEFAULT_DESIGN, designedShapes, LOBE_SHAPES } from '../../../../src/renderer/puffs/lobeShapes.ts';
import { orientationOf, rotatedLobes } from '../../../../src/renderer/puffs/orientation.ts';
import { CARTOON_KNOBS, proceduralPuff } from '../../../../src/renderer/puffs/procedural.ts';
import type { Lobe, PuffShape } from '../../../../src/renderer/puffs/shapes.ts';
import { dot } from '../../../../src/renderer/puffs/vector.ts';
import { MAX_LOBES } from '../../../../src/base/constants.ts';

const BALL: Lobe = { center: [0.1, -0.05, 0.2], radius: 0.7 };
const SIDES = Array.from({ length: 24 }, (_, side) => orientationOf((side * 11) % 256, 1.7 * side));
const GRID = Array.from({ length: 40 * 40 }, (_, i): [number, number] => [
  (i % 40) / 20 - 0.975,
  Math.floor(i / 40) / 20 - 0.975,
]);

test('a puff of one lobe is a ball: silhouette, height, normal', () => {
  for (const [x, y] of GRID) {
    const beside = Math.hypot(x - 0.1, y + 0.05);
    const { distance, height, normal } = sampleLobes([BALL], x, y);
    expect(distance).toBeCloseTo(beside - 0.7, 12);
    expect(height).toBeCloseTo(beside < 0.7 ? 0.2 + Math.sqrt(0.49 - beside * beside) : 0.2, 12);
    if (beside < 0.7) expect(normal[0]).toBeCloseTo((x - 0.1) / 0.7, 12);
  }
  expect(silhouetteRadius([BALL], 256)).toBeCloseTo(0.7, 2);
});

test('heights are on the surface: each point is on one lobe and inside none', () => {
  for (const { lobes } of LOBE_SHAPES) {
    for (const side of SIDES.slice(0, 6)) {
      const view = rotatedLobes(side, lobes);
      for (const [x, y] of GRID) {
        const { distance, height } = meetLobes(view, x, y);
        if (distance >= 0) continue;
        const gaps = view.map(({ center: c, radius }) => Math.hypot(x - c[0], y - c[1], height - c[2]) - radius);
        expect(Math.min(...gaps)).toBeCloseTo(0, 9);
      }
    }
  }
});

test('normals have unit length, and in smooth regions deviate by at most the blend share', () => {
  for (const { lobes } of LOBE_SHAPES) {
    for (const [x, y] of GRID) {
      const { distance, normal } = sampleLobes(lobes, x, y);
      if (distance >= 0) continue;
      expect(dot(normal, normal)).toBeCloseTo(1, 12);
      expect(normal[2]).toBeGreaterThan(-0.35);
    }
  }
});

test.each(LOBE_SHAPES)('$name is lobed and round from every side', ({ lobes }) => {
  for (const side of SIDES) {
    const view = rotatedLobes(side, lobes);
    const radius = silhouetteRadius(view);
    expect(radius).toBeGreaterThan(0.7);
    expect(radius).toBeLessThan(0.9);
    // Scallops: the deviation from a disc of the same area. A disc would have none.
    const outline = GRID.filter(([x, y]) => Math.abs(meetLobes(view, x, y).distance) < 0.03).map((at) =>
      Math.hypot(...at),
    );
    expect(Math.max(...outline) - Math.min(...outline)).toBeGreaterThan(0.18);
  }
});

test('a puff fits into the unit ball, and its visible surface is no deeper than volumes.vert assumes', () => {
  for (const { lobes } of LOBE_SHAPES) {
    expect(reachOf(lobes)).toBeLessThanOrEqual(1);
    expect(reachOf(lobes)).toBeGreaterThan(0.95);
    for (const side of SIDES) {
      const view = rotatedLobes(side, lobes);
      for (const [x, y] of GRID) expect(meetLobes(view, x, y).height).toBeGreaterThan(-0.6);
    }
  }
});

test('the same seed and knobs make the same puff, another seed another', () => {
  expect(proceduralPuff('a', 5)).toEqual(proceduralPuff('a', 5));
  expect(proceduralPuff('a', 5).lobes).not.toEqual(proceduralPuff('a', 6).lobes);
});

test('each knob has its documented effect', () => {
  const seeds = [1, 2, 3, 4, 5, 6, 7, 8];
  const mean = (measure: (shape: PuffShape) => number, knobs: Partial<typeof CARTOON_KNOBS>): number =>
    seeds.reduce((sum, seed) => sum + measure(proceduralPuff('x', seed, { ...CARTOON_KNOBS, ...knobs })), 0) / 8;
  const height = ({ lobes }: PuffShape): number => Math.max(...lobes.map(({ center, radius }) => center[1] + radius));
  expect(mean(height, { flatness: 1 })).toBeLessThan(0.85 * mean(height, { flatness: 0 }));
  const main = ({ lobes }: PuffShape): number => lobes[0].radius;
  expect(mean(main, { lumpiness: 1 })).toBeLessThan(0.85 * mean(main, { lumpiness: 0 }));
  const unlike = ({ lobes }: PuffShape): number => {
    const radii = lobes.slice(1).map(({ radius }) => radius);
    return Math.max(...radii) / Math.min(...radii);
  };
  expect(mean(unlike, { roughness: 0 })).toBeLessThan(1.01);
  expect(mean(unlike, { roughness: 1 })).toBeGreaterThan(1.4);
});

test('the default shapes are the four designed puffs, and more variations do not change them', () => {
  const [first, second, third, fourth] = designedShapes(DEFAULT_DESIGN, 9);
  expect([first, second, third, fourth]).toEqual([
    proceduralPuff('cauliflower', 7, { lumpiness: 0.8, flatness: 0.1, roughness: 0.6 }),
    proceduralPuff('drifter', 3, { lumpiness: 0.8, flatness: 0.35, roughness: 0.55 }),
    proceduralPuff('crown', 13, { lumpiness: 0.85, flatness: 0.15, roughness: 0.6 }),
    proceduralPuff('tumble', 14, { lumpiness: 0.85, flatness: 0.15, roughness: 0.6 }),
  ]);
});

test('every variation of every seed is a different shape, at any knobs', () => {
  const shapes = [0, 1, 2, 9999].flatMap((seed) => designedShapes({ ...DEFAULT_DESIGN, seed }, 32));
  expect(new Set(shapes.map(({ lobes }) => JSON.stringify(lobes))).size).toBe(128);
  for (const knob of [0, 1]) {
    const design = { lumpiness: knob, flatness: knob, roughness: knob, lobes: 5 + 7 * knob, seed: 3 };
    for (const { lobes } of designedShapes(design, 32)) {
      expect(lobes.length).toBe(design.lobes);
      expect(reachOf(lobes)).toBeLessThanOrEqual(1);
    }
  }
});

test('knobs and numbers out of range are rejected by name', () => {
  expect(() => proceduralPuff('x', 1, { ...CARTOON_KNOBS, flatness: 1.5 })).toThrow(/flatness is 1.5/);
  expect(() => proceduralPuff('x', 1, { ...CARTOON_KNOBS, lumpiness: NaN })).toThrow(/lumpiness is NaN/);
  expect(() => proceduralPuff('x', 1, CARTOON_KNOBS, MAX_LOBES + 1)).toThrow(/lobes is 13/);
  const many = { name: 'many', lobes: Array.from({ length: MAX_LOBES + 1 }, () => BALL) };
  expect(() => bakeLobes([many])).toThrow(/13 lobes/);
});

test('a table has a row for each variation, padded with neutral values', () => {
  const few = { name: 'few', lobes: [BALL] };
  const { table, lobeCount, count } = bakeLobes([LOBE_SHAPES[0], few]);
  expect([lobeCount, count, table.length]).toEqual([10, 2, 2 * 11 * 4]);
  const row = table.subarray(44);
  const filled = Array.from({ length: 10 }, (_, i): Lobe => {
    const [x, y, z, radius] = row.subarray(4 * i, 4 * i + 4);
    return { center: [x, y, z], radius };
  });
  for (const [x, y] of GRID) {
    const [padded, bare] = [meetLobes(filled, x, y), meetLobes([BALL], x, y)];
    expect(padded.height).toBeCloseTo(bare.height, 5);
    expect(padded.distance).toBeCloseTo(bare.distance, 5);
  }
});
