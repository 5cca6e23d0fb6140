/** Poses of models in closed form. */
import { expect, test } from 'vitest';
import { matrixOf, multiplyMatrices, inverted, Poser, rotationOf, sample } from '../../../../src/stage/model/pose.ts';
import { readModel, type Channel } from '../../../../src/stage/model/modelFile.ts';
import { bendingColumn, turningBox } from '../../../support/files/glb.ts';

const WORLD = { scale: 1, rotation: [0, 0, 0, 1], position: [0, 0, 0] } as const;

function channel(
  path: Channel['path'],
  interpolation: Channel['interpolation'],
  times: number[],
  values: number[],
): Channel {
  return { node: 0, path, interpolation, times: Float32Array.from(times), values: Float32Array.from(values) };
}

const line = [0, 0, 0, 2, 4, 8];
const spline = [0, 0, 0, 0, 0, 0, 3, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0];

test.each<[string, Channel, number, number[]]>([
  ['before the first key', channel('translation', 'LINEAR', [1, 2], line), 0.5, [0, 0, 0]],
  ['at a key', channel('translation', 'LINEAR', [1, 2], line), 2, [2, 4, 8]],
  ['between keys', channel('translation', 'LINEAR', [1, 2], line), 1.25, [0.5, 1, 2]],
  ['after the last key', channel('translation', 'LINEAR', [1, 2], line), 9, [2, 4, 8]],
  ['in steps', channel('translation', 'STEP', [1, 2], line), 1.99, [0, 0, 0]],
  ['between keys at one time', channel('translation', 'LINEAR', [1, 1], line), 1, [2, 4, 8]],
  // Cubic Hermite at 1/2: half of the end, and an eighth of the tangent at the start.
  ['on a spline', channel('translation', 'CUBICSPLINE', [0, 1], spline), 0.5, [0.5 + 3 / 8, 0.5, 0]],
  // The tangent is per second.
  ['on a longer spline', channel('translation', 'CUBICSPLINE', [0, 2], spline), 1, [0.5 + 6 / 8, 0.5, 0]],
])('a value %s', (_, given, time, expected) => {
  const into = [9, 9, 9, 0, 0, 0, 1, 1, 1, 1];
  sample(given, time, into);
  into.slice(0, 3).forEach((value, axis) => expect(value).toBeCloseTo(expected[axis], 6));
});

test('rotations take the shorter arc and have the length 1', () => {
  const into = [0, 0, 0, 0, 0, 0, 1, 1, 1, 1];
  sample(channel('rotation', 'LINEAR', [0, 1], [0, 0, 0, 1, 0, -Math.SQRT1_2, 0, -Math.SQRT1_2]), 0.5, into);
  [0, Math.sin(Math.PI / 8), 0, Math.cos(Math.PI / 8)].forEach((part, at) => expect(into[3 + at]).toBeCloseTo(part, 6));
});

test.each([0, 1, 2, 3, 3.5, 4, 41])('a node turns with the animation, which repeats, after %d s', (seconds) => {
  const file = readModel(turningBox().pack());
  const poser = new Poser(file, file.animations[0], 1, WORLD);
  const { position, rotation } = poser.placement(1, seconds);
  const [x, y, z, w] = rotation;
  const angle = (seconds * Math.PI) / 2;
  expect(position).toEqual([0, 1, 0]);
  // Between the keys, the middle is exact, too.
  expect(1 - 2 * (y * y + z * z)).toBeCloseTo(Math.cos(angle), 6);
  expect(2 * (x * z + w * y)).toBeCloseTo(Math.sin(angle), 6);
});

test('what carries a node moves it, scaled and turned by its place', () => {
  const file = readModel(bendingColumn().pack());
  const place = { scale: 2, rotation: [0, 1, 0, 0], position: [5, 0, 0] } as const;
  expect(new Poser(file, undefined, 1, place).placement(2, 0)).toEqual({ position: [5, 2, 0], rotation: [0, 1, 0, 0] });
});

test('a pose depends on the time only', () => {
  const file = readModel(turningBox().pack());
  const poser = new Poser(file, file.animations[0], 0.7, WORLD);
  const first = poser.placement(1, 1.3);
  for (let step = 0; step < 20; step++) poser.at(step / 7);
  expect(poser.placement(1, 1.3)).toEqual(first);
});

test('the inverse and the rotation of a matrix', () => {
  const rotation = [0.1, -0.7, 0.5, 0.5].map((part) => part / Math.sqrt(0.01 + 0.49 + 0.25 + 0.25));
  const matrix = matrixOf([1, 2, 3, ...rotation, 2, 3, 0.5]);
  const product = new Float64Array(16);
  multiplyMatrices(matrix, inverted(matrix)!, product);
  product.forEach((value, at) => expect(value).toBeCloseTo(at % 5 === 0 ? 1 : 0, 12));
  rotationOf(matrix).forEach((part, at) => expect(part).toBeCloseTo(rotation[at], 12));
  expect(inverted(matrixOf([0, 0, 0, 0, 0, 0, 1, 1, 0, 1]))).toBeUndefined();
});
