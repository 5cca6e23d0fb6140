import { expect, it } from 'vitest';
import { creaseEdges } from '../../../../../src/renderer/passes/edges/creaseEdges.ts';
import { ballMesh } from '../../../../../src/scenes/models/ball.ts';
import { tableMesh } from '../../../../../src/scenes/models/table.ts';
import { box, ground } from '../../../../visual/solids.ts';
import { finished } from '../../../../../src/base/work.ts';

it('finds the twelve edges of a cube and no diagonal of its faces', () => {
  const { count, ends } = finished(creaseEdges(box([0, 0, 0], [1, 1, 1]), 40));
  expect(count).toBe(12);
  for (let edge = 0; edge < count; ++edge) {
    const differs = [0, 1, 2].filter((axis) => ends[6 * edge + axis] !== ends[6 * edge + 3 + axis]);
    expect(differs).toHaveLength(1);
  }
});

it('finds none on a coarse but smooth ball, and both rims of a table', () => {
  expect(finished(creaseEdges(ballMesh(1, 6), 20)).count).toBe(0);
  expect(finished(creaseEdges(tableMesh(1, 0.1), 40)).count).toBe(2 * 96);
});

it('finds the border of an open mesh, whose edges have one face', () => {
  const { count, faceNormals } = finished(creaseEdges(ground(0, 1).mesh, 40));
  expect(count).toBe(4);
  expect(Array.from(faceNormals.subarray(0, 6), Math.abs)).toEqual([0, 1, 0, 0, 0, 0]);
});

it('leaves out edges under the angle', () => {
  expect(finished(creaseEdges(box([0, 0, 0], [1, 1, 1]), 91)).count).toBe(0);
});
