import type { TriangleMesh } from '../../renderer/passes/extrusion.ts';
import { tan } from '../../simulator/exact/arc.ts';
import type { Vector } from '../scene.ts';
import { every, strideWithin, normalized } from './revolve.ts';

/** Distance of a chamfered corner from a round one, in radii. */
const CHAMFER = 0.4;

/** The tangent axes u and v of each cube face, with u x v along the face normal. */
const FACES: readonly (readonly [axis: number, sign: 1 | -1, u: number, v: number])[] = [
  [0, 1, 1, 2],
  [0, -1, 2, 1],
  [1, 1, 2, 0],
  [1, -1, 0, 2],
  [2, 1, 0, 1],
  [2, -1, 1, 0],
];

/**
 * A closed box about the origin with rounded edges and corners.
 * @param radius of the edges and corners, or one per axis; half a side rounds it completely
 * @param cells per cube edge; odd, so that the middle cell becomes the flat part
 */
export function roundedBox(halfExtents: Vector, radius: number | Vector, cells = 9): TriangleMesh {
  const radii = typeof radius === 'number' ? [radius, radius, radius] : radius;
  const numbers = new Map<string, number>();
  const positions: number[] = [];
  const normals: number[] = [];
  const vertex = (cell: readonly number[]): number => {
    const key = cell.join();
    if (!numbers.has(key)) {
      numbers.set(key, numbers.size);
      const direction = normalized(cell.map((at) => tan((Math.PI / 4) * ((2 * at) / cells - 1))));
      normals.push(...normalized(direction.map((along, axis) => along / radii[axis])));
      const rounded = direction.map((along, axis) => radii[axis] * along);
      positions.push(...rounded.map((along, axis) => Math.sign(along) * (halfExtents[axis] - radii[axis]) + along));
    }
    return numbers.get(key)!;
  };
  const triangles = (lines: readonly number[], isChamfered: boolean): Uint32Array => {
    const indices: number[] = [];
    for (const [axis, sign, u, v] of FACES) {
      for (let i = 0; i + 1 < lines.length; i++) {
        for (let j = 0; j + 1 < lines.length; j++) {
          const corner = (right: number, up: number): number => {
            const cell = [0, 0, 0];
            [cell[axis], cell[u], cell[v]] = [sign > 0 ? cells : 0, lines[i + right], lines[j + up]];
            return vertex(isChamfered ? onOneFace(cell, cells) : cell);
          };
          const [a, b, c, d] = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
          if (a !== b && b !== c && c !== a) indices.push(a, b, c);
          if (a !== c && c !== d && d !== a) indices.push(a, c, d);
        }
      }
    }
    return Uint32Array.from(indices);
  };
  const largest = Math.max(...radii);
  const half = (cells - 1) / 2;
  const indices = triangles(every(1, cells), false);
  return {
    positions: Float32Array.from(positions),
    normals: Float32Array.from(normals),
    indices,
    coarser: (deviation) => {
      const before = every(Math.min(half, strideWithin(deviation, largest, 4 * cells)), half);
      const lines = [...before, ...before.map((line) => cells - line).toReversed()];
      return triangles(lines, deviation > CHAMFER * largest);
    },
  };
}

/** Moves a vertex of an edge or a corner to the flat part of one face that it belongs to. */
function onOneFace(cell: readonly number[], cells: number): number[] {
  const face = cell.findIndex((at) => at === 0 || at === cells);
  const flat = (cells - 1) / 2;
  return cell.map((at, axis) => (axis === face ? at : Math.min(flat + 1, Math.max(flat, at))));
}
