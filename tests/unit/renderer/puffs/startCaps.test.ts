import { expect, test } from 'vitest';
import { bakePuffs, samplePuff } from '../../../../src/renderer/puffs/billboards/layers.ts';
import { LOBE_SHAPES } from '../../../../src/renderer/puffs/lobeShapes.ts';
import { middleOf } from '../../../../src/renderer/puffs/normals.ts';
import { softNormal } from '../../../../src/renderer/puffs/softNormal.ts';
import { frontsOf } from '../../../../src/renderer/billboards.ts';
import { POINT_STRIDE, surfaceOf } from '../../../../src/renderer/puffs/bake/patches.ts';
import type { Lobe } from '../../../../src/renderer/puffs/shapes.ts';
import {
  NOTHING_LIT,
  bakeStartCaps,
  startCapAt,
  type StartCaps,
} from '../../../../src/renderer/puffs/bake/startCaps.ts';
import { minus } from '../../../../src/renderer/puffs/vector.ts';

type Vector = [number, number, number];

const layers = bakePuffs(LOBE_SHAPES);
const fronts = frontsOf(layers);

let state = 2006;
function next(): number {
  state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
  return state / 2 ** 32;
}

function randomDirection(): Vector {
  const z = 2 * next() - 1;
  const azimuth = 2 * Math.PI * next();
  const radius = Math.sqrt(1 - z * z);
  return [radius * Math.cos(azimuth), radius * Math.sin(azimuth), z];
}

const dot = (a: readonly number[], b: readonly number[]): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** Random positions on a puff's front, distributed like pixels. */
function surface(layer: number, count: number): { normal: readonly number[]; position: Vector }[] {
  return Array.from({ length: count }, () => [2 * next() - 1, 2 * next() - 1]).flatMap(([x, y]) => {
    const { normal, height, distance } = samplePuff(layers, layer, x, y);
    return distance <= 0 ? [{ normal, position: [x, y, height] as Vector }] : [];
  });
}

/** Distance of the farthest lit position behind the centre plane; -Infinity if none is lit. */
function farthestLit(places: ReturnType<typeof surface>, light: Vector, threshold: number): number {
  return places.reduce(
    (farthest, { normal, position }) =>
      dot(normal, light) > threshold ? Math.max(farthest, -dot(position, light)) : farthest,
    -Infinity,
  );
}

const cases = [-0.25, 0, 0.25, 0.5, 0.75].flatMap((threshold) =>
  LOBE_SHAPES.map(({ name }, layer): [number, string, number] => [threshold, name, layer]),
);
const tables = new Map<number, StartCaps>();
function capsFor(threshold: number): StartCaps {
  const caps = tables.get(threshold) ?? bakeStartCaps(fronts, threshold);
  tables.set(threshold, caps);
  return caps;
}

test.each(cases)('at threshold %f no lit point of %s is behind its cap, from any direction', (threshold, _, layer) => {
  const caps = capsFor(threshold);
  const places = surface(layer, 12_000);
  let slack = 0;
  let lit = 0;
  for (let trial = 0; trial < 150; trial++) {
    const light = randomDirection();
    const farthest = farthestLit(places, light, threshold);
    const cap = startCapAt(caps, layer, light);
    expect(cap).toBeGreaterThanOrEqual(farthest);
    if (farthest > -Infinity) [slack, lit] = [slack + cap - farthest, lit + 1];
  }
  // Also an upper bound: a volume that began far behind its puff would leave lit areas in the shadow.
  expect(slack / lit).toBeLessThan(0.16);
});

test('the lower the threshold of the ramp, the farther back the cap', () => {
  const [shallow, deep] = [capsFor(0.5), capsFor(0)];
  deep.values.forEach((cap, entry) => expect(cap).toBeGreaterThanOrEqual(shallow.values[entry]));
});

test('a cap never leaves the puff, also with light from straight behind', () => {
  const caps = capsFor(0.5);
  expect(startCapAt(caps, 0, [0, 0, -1])).toBe(NOTHING_LIT);
  for (const cap of caps.values) expect(Math.abs(cap)).toBeLessThanOrEqual(1.01);
});

test('a ball lit from N·L = 0.5 has its cap half a radius before the centre', () => {
  const ball = bakePuffs([{ name: 'ball', lobes: [{ center: [0, 0, 0], radius: 0.8 }] }]);
  const cap = startCapAt(bakeStartCaps(frontsOf(ball), 0.5), 0, [0, 0, 1]);
  expect(cap).toBeGreaterThan(-0.8 * 0.5);
  expect(cap).toBeLessThan(-0.8 * 0.5 + 0.1);
});

/** Random positions on the whole surface of a puff of lobes, distributed like pixels of all views. */
function allRound(lobes: readonly Lobe[], count: number): { normal: readonly number[]; position: Vector }[] {
  const middle = middleOf(lobes);
  return Array.from({ length: count }, () => {
    const { center, radius } = lobes[Math.floor(next() * lobes.length)];
    return randomDirection().map((n, axis) => center[axis] + radius * n) as Vector;
  })
    .filter((p) => lobes.every(({ center, radius }) => Math.hypot(...minus(p, center)) > radius - 1e-9))
    .map((position) => ({ position, normal: softNormal(lobes, middle, position) }));
}

test.each(LOBE_SHAPES.map(({ name }, layer): [string, number] => [name, layer]))(
  'no lit point of the lobes of %s is behind its cap, from any direction',
  (_, layer) => {
    const { lobes } = LOBE_SHAPES[layer];
    const caps = bakeStartCaps([surfaceOf(lobes)], 0.3);
    const places = allRound(lobes, 30_000);
    let slack = 0;
    for (let trial = 0; trial < 150; trial++) {
      const light = randomDirection();
      const farthest = farthestLit(places, light, 0.3);
      const cap = startCapAt(caps, 0, light);
      expect(cap).toBeGreaterThanOrEqual(farthest);
      slack += cap - farthest;
    }
    expect(slack / 150).toBeLessThan(0.16);
  },
);

test('is baked from few points: bounds reject most patches', () => {
  let visited = 0;
  const counting = fronts.map((patches) =>
    patches.map(({ points, ...bounds }) => ({
      ...bounds,
      get points() {
        visited += points.length / POINT_STRIDE;
        return points;
      },
    })),
  );
  const caps = bakeStartCaps(counting, 0.5);
  expect(caps.values).toEqual(capsFor(0.5).values);
  const points = fronts.flat().reduce((sum, patch) => sum + patch.points.length / POINT_STRIDE, 0);
  // Without culling each entry would visit all points.
  const all = points * caps.width * caps.height;
  expect(visited).toBeLessThan(0.22 * all);
});
