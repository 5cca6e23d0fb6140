import { expect, test } from 'vitest';
import { bakePuffs, type PuffLayers } from '../../src/puffs/layers.ts';
import { PUFF_SHAPES, type Lobe } from '../../src/puffs/shapes.ts';

const layers = bakePuffs(PUFF_SHAPES);

/** Whether a texel's centre lies inside the silhouette. */
function isInside({ size, colorCoverage }: PuffLayers, layer: number, texel: number): boolean {
  return colorCoverage[4 * (layer * size * size + texel) + 3] < 128;
}

/** Intersection over union of two silhouettes, the second turned by quarters. */
function overlap(a: number, b: number, quarters: number): number {
  const { size } = layers;
  let both = 0;
  let either = 0;
  for (let texel = 0; texel < size * size; texel++) {
    let [x, y] = [texel % size, Math.floor(texel / size)];
    for (let i = 0; i < quarters; i++) [x, y] = [size - 1 - y, x];
    const inA = isInside(layers, a, texel);
    const inB = isInside(layers, b, y * size + x);
    both += inA && inB ? 1 : 0;
    either += inA || inB ? 1 : 0;
  }
  return both / either;
}

const pairs = PUFF_SHAPES.flatMap((_, a) => PUFF_SHAPES.slice(a + 1).map((__, i): [number, number] => [a, a + 1 + i]));

test('there are at least four shapes of 5 to 9 lobes with different names', () => {
  expect(PUFF_SHAPES.length).toBeGreaterThanOrEqual(4);
  expect(new Set(PUFF_SHAPES.map(({ name }) => name)).size).toBe(PUFF_SHAPES.length);
  for (const { lobes } of PUFF_SHAPES) {
    expect(lobes.length).toBeGreaterThanOrEqual(5);
    expect(lobes.length).toBeLessThanOrEqual(9);
  }
});

test.each(pairs)('silhouettes %i and %i overlap in less than 0.9 of their union, however one is turned', (a, b) => {
  for (let quarters = 0; quarters < 4; quarters++) expect(overlap(a, b, quarters)).toBeLessThan(0.9);
});

/** The lobe that is seen at (x, y), or -1. */
function lobeAt(lobes: readonly Lobe[], x: number, y: number): number {
  let [nearest, highest] = [-1, -Infinity];
  lobes.forEach(({ center, radius }, i) => {
    const squared = radius ** 2 - (x - center[0]) ** 2 - (y - center[1]) ** 2;
    const height = center[2] + Math.sqrt(squared);
    if (squared > 0 && height > highest) [nearest, highest] = [i, height];
  });
  return nearest;
}

test.each(PUFF_SHAPES)('every lobe of $name shows at least 3 %% of the picture, none a third', ({ lobes }) => {
  const seen = lobes.map(() => 0);
  for (let i = 0; i < 200 * 200; i++) {
    const lobe = lobeAt(lobes, (i % 200) / 100 - 0.995, Math.floor(i / 200) / 100 - 0.995);
    if (lobe >= 0) seen[lobe]++;
  }
  const total = seen.reduce((sum, count) => sum + count, 0);
  for (const count of seen) {
    expect(count / total).toBeGreaterThan(0.03);
    expect(count / total).toBeLessThan(1 / 3);
  }
});

test.each(PUFF_SHAPES.map(({ name }, layer) => ({ name, layer })))('$name fits its frame and is round', ({ layer }) => {
  const figures = layers.figures[layer];
  expect(figures.outerRadius).toBeLessThanOrEqual(1);
  expect(figures.silhouetteRadius).toBeGreaterThan(0.8);
  expect(figures.silhouetteRadius).toBeLessThan(0.88);
  expect(figures.inscribedRadius).toBeGreaterThan(0.55);
  // Scallops, not a disc: the silhouette swings by a quarter of its radius.
  expect(figures.outerRadius - figures.inscribedRadius).toBeGreaterThan(0.25 * figures.silhouetteRadius);
});

test.each(PUFF_SHAPES.map(({ name }, layer) => ({ name, layer })))('$name bulges like a ball', ({ layer }) => {
  const { relief, silhouetteRadius } = layers.figures[layer];
  expect(relief).toBeGreaterThan(0.7 * silhouetteRadius);
  expect(relief).toBeLessThanOrEqual(1);
  expect(meanHeight(layer)).toBeGreaterThan(0.7 * (2 / 3) * silhouetteRadius);
});

/** Mean height over the silhouette; two thirds of the radius for a hemisphere. */
function meanHeight(layer: number): number {
  const { size, pad, normalDepth } = layers;
  let sum = 0;
  let count = 0;
  for (let texel = 0; texel < size * size; texel++) {
    if (!isInside(layers, layer, texel)) continue;
    const depth = halfToNumber(normalDepth[4 * (layer * size * size + texel) + 3]);
    sum += (depth - 0.5) * 2 * pad;
    count++;
  }
  return sum / count;
}

/** Read independently of the code under test: normal half floats only. */
function halfToNumber(half: number): number {
  return (1 + (half & 1023) / 1024) * 2 ** ((half >> 10) - 15);
}
