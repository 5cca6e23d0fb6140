/**
 * Boxes of a page in the smoke, for cameras from all sides: the intersection of each collider with the picture plane is
 * the box.
 */
import { Quaternion, Vector3 } from 'three';
import { expect, test } from 'vitest';
import { colliderValues, emitterValues } from '../../../../src/page/element/layout/pageValues.ts';
import type { ScenePlane } from '../../../../src/stage/sight.ts';

const PIXEL = 0.01;
const MIDDLE = new Vector3(0.3, 1.2, -0.4);
const [HALF_WIDTH, HALF_HEIGHT] = [0.5, 0.2];
const PLACE = { middle: tuple(MIDDLE), top: tuple(MIDDLE), halfWidth: HALF_WIDTH, halfHeight: HALF_HEIGHT };
const EYES = [0, 0.3, Math.PI / 4, 1.2, Math.PI / 2, 2.5, Math.PI, -2].flatMap((azimuth) =>
  [0, 0.5, -0.4, 1.4].map((elevation) => [azimuth, elevation] as const),
);

type Tuple = [number, number, number];

function tuple({ x, y, z }: Vector3): Tuple {
  return [x, y, z];
}

/** Right and up vectors of a camera at these angles, unit length. */
function axesOf(azimuth: number, elevation: number): { right: Vector3; up: Vector3 } {
  const right = new Vector3(Math.cos(azimuth), 0, -Math.sin(azimuth));
  const away = Math.sin(elevation);
  const up = new Vector3(-away * Math.sin(azimuth), Math.cos(elevation), -away * Math.cos(azimuth));
  return { right, up };
}

function planeOf({ right, up }: { right: Vector3; up: Vector3 }): ScenePlane {
  const pixel = (way: Vector3) => tuple(way.clone().multiplyScalar(PIXEL));
  return { middle: tuple(MIDDLE), right: pixel(right), up: pixel(up) };
}

test.each(EYES)('an obstacle has the width and the height of its box, from %f and %f', (azimuth, elevation) => {
  const axes = axesOf(azimuth, elevation);
  const values = colliderValues([PLACE], planeOf(axes)) as Record<string, number>;
  const read = (name: string) => new Vector3(...['x', 'y', 'z'].map((axis) => values[`colliders.0.${name}.${axis}`]));
  // As in the simulator: the shortest rotation of the y axis to the given axis.
  const rotation = new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), read('axis').normalize());
  const half = read('halfExtents');
  const isWithin = (x: number, y: number) => {
    const place = MIDDLE.clone().addScaledVector(axes.right, x).addScaledVector(axes.up, y);
    const local = place.sub(read('position')).applyQuaternion(rotation.clone().invert());
    return Math.abs(local.x) <= half.x && Math.abs(local.y) <= half.y && Math.abs(local.z) <= half.z;
  };
  const edge = 0.004;
  for (const [x, y] of [
    [1, 0],
    [-1, 0],
    [0, 1],
    [0, -1],
    [1, 1],
    [-1, 1],
  ]) {
    expect(isWithin(x * (HALF_WIDTH - edge), y * (HALF_HEIGHT - edge))).toBe(true);
    if (x !== 0) expect(isWithin(x * (HALF_WIDTH + edge), 0)).toBe(false);
    if (y !== 0) expect(isWithin(0, y * (HALF_HEIGHT + edge))).toBe(false);
  }
});

test.each(EYES)('smoke starts along the whole width of its element, from %f and %f', (azimuth, elevation) => {
  const axes = axesOf(azimuth, elevation);
  const values = emitterValues([{ place: PLACE, isOn: true }], planeOf(axes), 10) as Record<string, number>;
  const [x, z] = ['x', 'z'].map((axis) => values[`emitters.0.extent.${axis}`]);
  const widest = Math.abs(axes.right.x) * x + Math.abs(axes.right.z) * z;
  expect(Math.abs(widest - HALF_WIDTH)).toBeLessThan(0.025);
});
