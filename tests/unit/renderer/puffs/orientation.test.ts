import { expect, test } from 'vitest';
import { orientationOf, rotated, type Rotation } from '../../../../src/renderer/puffs/orientation.ts';
import { dot, lengthOf, minus, spherePoint } from '../../../../src/renderer/puffs/vector.ts';

const SEEDS = Array.from({ length: 256 }, (_, seed) => seed);

function product(a: Rotation, b: Rotation): Rotation {
  return [rotated(a, b[0]), rotated(a, b[1]), rotated(a, b[2])];
}

function trace([a, b, c]: Rotation): number {
  return a[0] + b[1] + c[2];
}

test('an orientation rotates by the roll about the axis of the seed', () => {
  for (const seed of SEEDS) {
    const roll = (seed * 2.4) % 6.28;
    const rotation = orientationOf(seed, roll);
    const axis = spherePoint(seed, 256);
    expect(lengthOf(minus(rotated(rotation, axis), axis))).toBeLessThan(1e-12);
    expect(trace(rotation)).toBeCloseTo(1 + 2 * Math.cos(roll), 12);
    const [x, y, z] = rotation;
    for (const [a, b] of [[x, y], [y, z], [z, x]] as const) expect(dot(a, b)).toBeCloseTo(0, 12); // prettier-ignore
    // Right-handed around the axis: excludes mirror images and the opposite direction.
    const side = rotated(orientationOf(seed, Math.PI / 2), rotated(orientationOf(seed, Math.PI / 2), x));
    expect(lengthOf(minus(side, rotated(orientationOf(seed, Math.PI), x)))).toBeLessThan(1e-12);
  }
  expect(rotated(orientationOf(0, Math.PI / 2), [1, 0, 0])[1]).toBeGreaterThan(0.98);
});

test('rolls add up, and a full turn is the identity', () => {
  for (const seed of SEEDS) {
    const twice = product(orientationOf(seed, 0.7), orientationOf(seed, 0.5));
    for (const axis of [0, 1, 2]) {
      expect(lengthOf(minus(twice[axis], orientationOf(seed, 1.2)[axis]))).toBeLessThan(1e-12);
      expect(lengthOf(minus(orientationOf(seed, 2 * Math.PI)[axis], orientationOf(seed, 0)[axis]))).toBeLessThan(1e-12);
    }
  }
});

test('the axes of all seeds spread over the sphere', () => {
  for (const seed of SEEDS) {
    const nearest = SEEDS.filter((other) => other !== seed).reduce(
      (least, other) => Math.min(least, lengthOf(minus(spherePoint(seed, 256), spherePoint(other, 256)))),
      2,
    );
    // 256 discs of this radius cover most of the sphere's area, 4 pi.
    expect(nearest / 2).toBeGreaterThan(0.08);
  }
});
