import { GOLDEN_ANGLE } from '../../base/constants.ts';

/** A three-dimensional vector. */
export type Vector = readonly [x: number, y: number, z: number];

export function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

export function minus(a: Vector, b: Vector): Vector {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

export function lengthOf(a: Vector): number {
  return Math.sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

/** `a + (b - a) * share`. */
export function mixed(a: Vector, b: Vector, share: number): Vector {
  return [a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share, a[2] + (b[2] - a[2]) * share];
}

/** The unit vector in the direction of `a`; the zero vector stays zero. */
export function normalized(a: Vector): Vector {
  const length = Math.sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]) || 1;
  return [a[0] / length, a[1] / length, a[2] / length];
}

/**
 * Point `index` of a Fibonacci lattice of `count` points on the unit sphere, along a spiral about z, after Gonzalez,
 * 'Measurement of Areas on a Sphere Using Fibonacci and Latitude-Longitude Lattices' (2010).
 */
export function spherePoint(index: number, count: number): Vector {
  const z = 1 - (2 * index + 1) / count;
  const reach = Math.sqrt(1 - z * z);
  return [reach * Math.cos(index * GOLDEN_ANGLE), reach * Math.sin(index * GOLDEN_ANGLE), z];
}
