/** The functions that scenes use instead of the engine's: as accurate, and bit-exact everywhere. */
import { createHash } from 'node:crypto';
import { Euler, Quaternion, Vector3 } from 'three';
import { expect, test } from 'vitest';
import { acos, asin, atan2, tan } from '../../../src/simulator/exact/arc.ts';
import { exp, pow } from '../../../src/simulator/exact/power.ts';
import { anglesYZX, multiply, slerp } from '../../../src/simulator/exact/quaternion.ts';
import { cos, hypot, sin } from '../../../src/simulator/exact/sine.ts';
import { rotate, quaternionFromAngles } from '../../../src/simulator/exact/rotation.ts';
import { random } from '../../visual/random.ts';

type Range = readonly [min: number, max: number];
type Function = (...given: number[]) => number;

/** Ten hours in seconds times the highest rate of a scene, 47 rad/s. */
const FAR: Range = [-1.7e6, 1.7e6];
/**
 * Each with the engine's function, the ranges of its arguments, and an error bound: absolute, or relative to the
 * result.
 */
const FUNCTIONS: readonly [string, Function, Function, readonly Range[], number, 'absolute' | 'relative'][] = [
  ['sin', sin, Math.sin, [[-10, 10]], 3e-16, 'absolute'],
  ['sin far away', sin, Math.sin, [FAR], 3e-16, 'absolute'],
  ['sin of small angles', sin, Math.sin, [[-0.01, 0.01]], 5e-16, 'relative'],
  ['cos', cos, Math.cos, [[-10, 10]], 3e-16, 'absolute'],
  ['cos far away', cos, Math.cos, [FAR], 3e-16, 'absolute'],
  ['tan', tan, Math.tan, [[-1.5, 1.5]], 8e-16, 'relative'],
  ['asin', asin, Math.asin, [[-1, 1]], 8e-16, 'relative'],
  ['acos', acos, Math.acos, [[-1, 1]], 8e-16, 'relative'],
  ['atan2', atan2, Math.atan2, [[-3, 3], [-3, 3]], 8e-16, 'relative'],
  ['atan2 of small angles', atan2, Math.atan2, [[-1e-6, 1e-6], [0.5, 1]], 8e-16, 'relative'],
  ['exp', exp, Math.exp, [[-30, 30]], 5e-16, 'relative'],
  ['exp of large powers', exp, Math.exp, [[-700, 700]], 5e-16, 'relative'],
  ['pow 1.5', (base) => pow(base, 1.5), (base) => Math.pow(base, 1.5), [[0, 40]], 8e-16, 'relative'],
  ['pow', pow, Math.pow, [[0.001, 1000], [-3, 3]], 2e-15, 'relative'],
  ['hypot', hypot, Math.hypot, [[-9, 9], [-9, 9], [-9, 9]], 5e-16, 'relative'],
]; // prettier-ignore

/** Seeded rows of numbers within ranges. */
function rows(count: number, ranges: readonly Range[]): number[][] {
  const next = random(7);
  return Array.from({ length: count }, () => ranges.map(([min, max]) => min + (max - min) * next()));
}

test.each(FUNCTIONS)('%s is as accurate as the function of the engine', (_, own, engine, ranges, bound, kind) => {
  let worst = 0;
  for (const given of rows(4000, ranges)) {
    const [found, expected] = [own(...given), engine(...given)];
    worst = Math.max(worst, Math.abs(found - expected) / (kind === 'relative' ? Math.abs(expected) : 1));
  }
  expect(worst).toBeLessThan(bound);
});

/** The first digits of a hash of the numbers' bits. */
function hashOf(numbers: readonly number[]): string {
  const bytes = new DataView(new ArrayBuffer(8 * numbers.length));
  numbers.forEach((number, index) => bytes.setFloat64(8 * index, number));
  return createHash('sha256').update(bytes).digest('hex').slice(0, 16);
}

test('4,000 results of each function are bit-exact for takes of version 3', () => {
  const hashes = FUNCTIONS.map(([name, own, , ranges]) => [name, hashOf(rows(4000, ranges).map((row) => own(...row)))]);
  expect(Object.fromEntries(hashes)).toMatchInlineSnapshot(`
    {
      "acos": "33cc74ad65b4cab9",
      "asin": "919176566bc51300",
      "atan2": "32fc8464f2fdd94a",
      "atan2 of small angles": "68c5ef6819c65702",
      "cos": "47ce9ec9bf8d88f1",
      "cos far away": "bdee789b4dcb580a",
      "exp": "390ee2311317dc3c",
      "exp of large powers": "3a68e916e3838695",
      "hypot": "d1c21388c8403271",
      "pow": "28036eee9def5641",
      "pow 1.5": "f0985aeb24c36bba",
      "sin": "9357ca81dfff32d3",
      "sin far away": "c6f0ad0e524e924c",
      "sin of small angles": "324af6ba31f8dc19",
      "tan": "d6ec7e7f1c44bbe7",
    }
  `);
});

test('special values give exact results', () => {
  expect([sin(0), cos(0), tan(0), asin(0), exp(0)]).toEqual([0, 1, 0, 0, 1]);
  expect([sin(Math.PI / 2), cos(Math.PI), sin(-Math.PI / 2)]).toEqual([1, -1, -1]);
  expect([asin(1), asin(-1), acos(1), acos(-1)]).toEqual([Math.PI / 2, -Math.PI / 2, 0, Math.PI]);
  expect([atan2(0, 1), atan2(1, 1), atan2(1, 0), atan2(0, -1), atan2(-1, 0), atan2(0, 0)]).toEqual(
    [0, Math.PI / 4, Math.PI / 2, Math.PI, -Math.PI / 2, 0],
  ); // prettier-ignore
  expect([hypot(3, 4), hypot(2, 3, 6), hypot(0, 0)]).toEqual([5, 7, 0]);
  expect([pow(0, 1.5), pow(1, 7.3), pow(4, 1.5), pow(2, -3), pow(0.25, 0.5)]).toEqual([0, 1, 8, 0.125, 0.5]);
  expect([pow(-1, 2), sin(Infinity), cos(NaN), exp(NaN), atan2(NaN, 1)]).toEqual([NaN, NaN, NaN, NaN, NaN]);
});

const ANGLES = rows(200, [[-3, 3], [-1.5, 1.5], [-3, 3]]) as [number, number, number][]; // prettier-ignore
const ORDERS = ['ZYX', 'YZX'] as const;

function closeTo(found: readonly number[], expected: readonly number[]): void {
  expect(found).toHaveLength(expected.length);
  expect(Math.max(...found.map((part, index) => Math.abs(part - expected[index])))).toBeLessThan(2e-15);
}

test.each(ORDERS)('angles make the quaternions of three.js in the order %s', (order) => {
  for (const [x, y, z] of ANGLES) {
    const quaternion =
      order === 'ZYX'
        ? quaternionFromAngles([x, y, z])
        : multiply(quaternionFromAngles([0, y, 0]), quaternionFromAngles([x, 0, z]));
    closeTo(quaternion, new Quaternion().setFromEuler(new Euler(x, y, z, order)).toArray());
  }
});

test('quaternions rotate vectors as in three.js', () => {
  for (const [index, angles] of ANGLES.entries()) {
    const [quaternion, vector] = [quaternionFromAngles(angles), ANGLES[199 - index]];
    closeTo(
      rotate(quaternion, vector),
      new Vector3(...vector).applyQuaternion(new Quaternion(...quaternion)).toArray(),
    );
  }
});

test('a quaternion is converted back to its angles', () => {
  for (const [x, y, z] of ANGLES) {
    const angles = [x, 2 * y, z / 2.1];
    const quaternion = multiply(
      quaternionFromAngles([0, angles[1], 0]),
      quaternionFromAngles([angles[0], 0, angles[2]]),
    );
    // Near z = pi / 2 the angles of a rounded quaternion are ill-conditioned.
    anglesYZX(quaternion).forEach((angle, axis) => expect(Math.abs(angle - angles[axis])).toBeLessThan(1e-13));
  }
  const upright = multiply(quaternionFromAngles([0, 0.4, 0]), quaternionFromAngles([0, 0, Math.PI / 2]));
  const [x, y, z] = anglesYZX(upright);
  expect(x).toBe(0);
  expect(y).toBeCloseTo(0.4, 12);
  expect(z).toBeCloseTo(Math.PI / 2, 7);
});

test('slerp matches three.js for small and large angles', () => {
  for (const [index, angles] of ANGLES.entries()) {
    const from = quaternionFromAngles(angles);
    const near = multiply(quaternionFromAngles([0.01, 0, 0.005]), from);
    for (const to of [quaternionFromAngles(ANGLES[199 - index]), near, from]) {
      for (const share of [0, 0.08, 0.5, 1]) {
        const expected = new Quaternion(...from).slerp(new Quaternion(...to), share).normalize();
        closeTo(slerp(from, to, share), expected.toArray());
      }
    }
  }
});
