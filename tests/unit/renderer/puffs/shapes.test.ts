/** Billboards of the default puffs. */
import { expect, test } from 'vitest';
import { bakePuffs, type PuffLayers } from '../../../../src/renderer/puffs/billboards/layers.ts';
import { LOBE_SHAPES } from '../../../../src/renderer/puffs/lobeShapes.ts';

const layers = bakePuffs(LOBE_SHAPES);

/** Whether the centre of a texel is inside the silhouette. */
function isInside({ size, colorCoverage }: PuffLayers, layer: number, texel: number): boolean {
  return colorCoverage[4 * (layer * size * size + texel) + 3] < 128;
}

/** Intersection over union of two silhouettes, the second rotated by quarter turns. */
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

const pairs = LOBE_SHAPES.flatMap((_, a) => LOBE_SHAPES.slice(a + 1).map((__, i): [number, number] => [a, a + 1 + i]));

test.each(pairs)('silhouettes %i and %i overlap in less than 0.9 of their union at every rotation', (a, b) => {
  for (let quarters = 0; quarters < 4; quarters++) expect(overlap(a, b, quarters)).toBeLessThan(0.9);
});

test.each(LOBE_SHAPES.map(({ name }, layer) => ({ name, layer })))('$name fits its frame and is round', ({ layer }) => {
  const figures = layers.figures[layer];
  expect(figures.outerRadius).toBeLessThanOrEqual(1);
  expect(figures.depth).toBeLessThanOrEqual(1);
  expect(figures.silhouetteRadius).toBeGreaterThan(0.75);
  expect(figures.silhouetteRadius).toBeLessThan(0.88);
  expect(figures.inscribedRadius).toBeGreaterThan(0.5);
  // Scallops instead of a disc: the silhouette varies by a quarter of its radius.
  expect(figures.outerRadius - figures.inscribedRadius).toBeGreaterThan(0.25 * figures.silhouetteRadius);
});

test.each(LOBE_SHAPES.map(({ name }, layer) => ({ name, layer })))('$name bulges like a ball', ({ layer }) => {
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

/** Independent of the code under test; supports normal half floats only. */
function halfToNumber(half: number): number {
  return (1 + (half & 1023) / 1024) * 2 ** ((half >> 10) - 15);
}
