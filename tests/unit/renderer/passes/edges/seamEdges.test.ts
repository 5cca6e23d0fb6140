import { expect, it } from 'vitest';
import type { TriangleMesh } from '../../../../../src/renderer/passes/extrusion.ts';
import { seamEdges } from '../../../../../src/renderer/passes/edges/seamEdges.ts';
import { ballMesh } from '../../../../../src/scenes/models/ball.ts';
import { box, ground } from '../../../../visual/solids.ts';
import { finished } from '../../../../../src/base/work.ts';

const FLOOR = ground(0, 5).mesh;

/** Lengths of the segments of a seam, metres, and the end points of each. */
function seamOf(one: TriangleMesh, other: TriangleMesh): { length: number; places: number[][] } {
  const { count, ends } = finished(seamEdges(one, other));
  const places = Array.from({ length: 2 * count }, (_, place) => [...ends.subarray(3 * place, 3 * place + 3)]);
  const length = Array.from({ length: count }, (_, edge) => {
    const [from, to] = [places[2 * edge], places[2 * edge + 1]];
    return Math.hypot(...from.map((value, axis) => to[axis] - value));
  }).reduce((sum, piece) => sum + piece, 0);
  return { length, places };
}

it.each([
  ['stands on', 0.5],
  ['stands in', 0.3],
])('runs once around a box that %s a floor', (_, height) => {
  const { length, places } = seamOf(box([0.2, height, 0.1], [0.5, 0.5, 0.5]), FLOOR);
  expect(length).toBeCloseTo(4, 4);
  for (const [x, y, z] of places) {
    expect(y).toBeCloseTo(0, 4);
    expect(Math.max(Math.abs(x - 0.2), Math.abs(z - 0.1))).toBeCloseTo(0.5, 4);
  }
});

it('is a circle where a ball intersects a floor, in either order', () => {
  const ball = ballMesh(1, 64);
  for (let at = 1; at < ball.positions.length; at += 3) ball.positions[at] += 0.6;
  for (const { length, places } of [seamOf(ball, FLOOR), seamOf(FLOOR, ball)]) {
    expect(length / (2 * Math.PI * 0.8)).toBeCloseTo(1, 2);
    for (const [x, , z] of places) expect(Math.hypot(x, z)).toBeCloseTo(0.8, 2);
  }
});

it('is empty for surfaces that are apart or coplanar', () => {
  expect(finished(seamEdges(box([0, 0.51, 0], [0.5, 0.5, 0.5]), FLOOR)).count).toBe(0);
  expect(finished(seamEdges(ground(0, 1).mesh, FLOOR)).count).toBe(0);
});
