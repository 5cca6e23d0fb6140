import type { TriangleMesh } from '../../src/renderer/passes/extrusion.ts';
import type { SurfaceDescription } from '../../src/renderer/passes/surface.ts';

type Triple = readonly [number, number, number];

/** A horizontal square that receives shadow and casts none. */
export function ground(y: number, half: number): SurfaceDescription {
  const mesh = {
    positions: new Float32Array([-half, y, -half, half, y, -half, half, y, half, -half, y, half]),
    normals: new Float32Array([0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0]),
    indices: new Uint32Array([0, 2, 1, 0, 3, 2]),
  };
  return { name: 'ground', mesh, color: [222, 170, 110], casts: false, inked: false };
}

/** A closed box with flat faces. */
export function box(centre: Triple, half: Triple): TriangleMesh {
  const positions: number[] = [];
  const normals: number[] = [];
  const indices: number[] = [];
  for (const axis of [0, 1, 2]) {
    for (const side of [-1, 1]) {
      const first = positions.length / 3;
      const [u, v] = side > 0 ? [(axis + 1) % 3, (axis + 2) % 3] : [(axis + 2) % 3, (axis + 1) % 3];
      for (const [a, b] of [
        [-1, -1],
        [1, -1],
        [1, 1],
        [-1, 1],
      ]) {
        const corner = [0, 0, 0];
        corner[axis] = side;
        corner[u] = a;
        corner[v] = b;
        positions.push(...corner.map((sign, index) => centre[index] + sign * half[index]));
        normals.push(...[0, 1, 2].map((index) => (index === axis ? side : 0)));
      }
      indices.push(first, first + 1, first + 2, first, first + 2, first + 3);
    }
  }
  return {
    positions: new Float32Array(positions),
    normals: new Float32Array(normals),
    indices: new Uint32Array(indices),
  };
}
