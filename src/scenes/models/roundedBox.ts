import type { TriangleMesh } from '../../passes/extrusion.ts';
import { tan } from '../../sim/exact/arc.ts';
import type { Vector } from '../scene.ts';
import { normalized } from './revolve.ts';

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
  const indices: number[] = [];
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
  for (const [axis, sign, u, v] of FACES) {
    for (let i = 0; i < cells; i++) {
      for (let j = 0; j < cells; j++) {
        const corner = (right: number, up: number): number => {
          const cell = [0, 0, 0];
          [cell[axis], cell[u], cell[v]] = [sign > 0 ? cells : 0, i + right, j + up];
          return vertex(cell);
        };
        indices.push(corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 0), corner(1, 1), corner(0, 1));
      }
    }
  }
  return {
    positions: Float32Array.from(positions),
    normals: Float32Array.from(normals),
    indices: Uint32Array.from(indices),
  };
}
