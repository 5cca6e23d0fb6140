import { expect, test } from 'vitest';
import { nearestCells, signedDistance } from '../../../../src/renderer/puffs/billboards/distance.ts';

/** A grid of zeros and ones from a predicate of the cell's column and row. */
function grid(size: number, isCovered: (x: number, y: number) => boolean): Uint8Array {
  return Uint8Array.from({ length: size * size }, (_, cell) =>
    isCovered(cell % size, Math.floor(cell / size)) ? 1 : 0,
  );
}

function bruteSquaredDistance(coverage: Uint8Array, value: 0 | 1, size: number, cell: number): number {
  let least = Infinity;
  for (let other = 0; other < coverage.length; other++) {
    if (coverage[other] !== value) continue;
    const dx = (other % size) - (cell % size);
    const dy = Math.floor(other / size) - Math.floor(cell / size);
    least = Math.min(least, dx * dx + dy * dy);
  }
  return least;
}

test.each([0.5, 0.05, 0.005])('is exact on a random grid with a fraction of %f covered', (share) => {
  const size = 37;
  let state = 12345;
  const next = (): number => (state = (Math.imul(state, 1664525) + 1013904223) >>> 0) / 2 ** 32;
  const coverage = grid(size, () => next() < share);
  for (const value of [0, 1] as const) {
    const { nearest, squaredDistance } = nearestCells(coverage, value, size);
    for (let cell = 0; cell < coverage.length; cell++) {
      expect(squaredDistance[cell]).toBe(bruteSquaredDistance(coverage, value, size, cell));
      expect(coverage[nearest[cell]]).toBe(value);
      const dx = (nearest[cell] % size) - (cell % size);
      const dy = Math.floor(nearest[cell] / size) - Math.floor(cell / size);
      expect(dx * dx + dy * dy).toBe(squaredDistance[cell]);
    }
  }
});

test('has no nearest cell of an empty set', () => {
  const { nearest, squaredDistance } = nearestCells(
    grid(8, () => false),
    1,
    8,
  );
  expect(new Set(nearest)).toEqual(new Set([-1]));
  expect(new Set(squaredDistance)).toEqual(new Set([Infinity]));
  expect(
    signedDistance(
      grid(8, () => false),
      8,
    ).every((distance) => distance === Infinity),
  ).toBe(true);
  expect(
    signedDistance(
      grid(8, () => true),
      8,
    ).every((distance) => distance === -Infinity),
  ).toBe(true);
});

test('the signed distance to a disc is exact within 0.71 cells, and negative inside', () => {
  const [size, radius, middle] = [200, 61.3, 99.7];
  const fromMiddle = (x: number, y: number): number => Math.hypot(x - middle, y - middle);
  const signed = signedDistance(
    grid(size, (x, y) => fromMiddle(x, y) < radius),
    size,
  );
  signed.forEach((distance, cell) => {
    const expected = fromMiddle(cell % size, Math.floor(cell / size)) - radius;
    // Tolerance: half a diagonal, because the border is between two cell centres.
    expect(Math.abs(distance - expected)).toBeLessThan(Math.SQRT1_2);
  });
});
