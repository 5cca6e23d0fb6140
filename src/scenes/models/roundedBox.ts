import type { TriangleMesh } from '../../passes/extrusion.ts';
import type { Vector } from '../scene.ts';

/** Cells along each edge of the cube that is blown up; odd, so that the middle one becomes the flat part. */
const CELLS = 9;

/** Two directions along the face of a cube that looks along an axis, such that u x v is that axis. */
const FACES: readonly (readonly [axis: number, sign: 1 | -1, u: number, v: number])[] = [
  [0, 1, 1, 2],
  [0, -1, 2, 1],
  [1, 1, 2, 0],
  [1, -1, 0, 2],
  [2, 1, 0, 1],
  [2, -1, 1, 0],
];

/** A closed box about the origin with round edges and corners; a radius of half its least side makes a pill. */
export function roundedBox(halfExtents: Vector, radius: number): TriangleMesh {
  const numbers = new Map<string, number>();
  const positions: number[] = [];
  const normals: number[] = [];
  const indices: number[] = [];
  const vertex = (cell: readonly number[]): number => {
    const key = cell.join();
    if (!numbers.has(key)) {
      numbers.set(key, numbers.size);
      const direction = unit(cell.map((at) => Math.tan((Math.PI / 4) * ((2 * at) / CELLS - 1))));
      normals.push(...direction);
      positions.push(...direction.map((part, axis) => Math.sign(part) * (halfExtents[axis] - radius) + radius * part));
    }
    return numbers.get(key)!;
  };
  for (const [axis, sign, u, v] of FACES) {
    for (let i = 0; i < CELLS; i++) {
      for (let j = 0; j < CELLS; j++) {
        const corner = (right: number, up: number): number => {
          const cell = [0, 0, 0];
          [cell[axis], cell[u], cell[v]] = [sign > 0 ? CELLS : 0, i + right, j + up];
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

function unit(vector: readonly number[]): number[] {
  const length = Math.hypot(...vector);
  return vector.map((part) => part / length);
}
