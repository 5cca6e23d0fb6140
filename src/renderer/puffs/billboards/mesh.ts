/**
 * Triangle meshes of puffs: one closed icosphere per lobe. The lobes overlap; the depth test produces the exact creases
 * between them.
 */
import { middleOf, NORMAL_BLEND } from '../normals.ts';
import { softNormal } from '../softNormal.ts';
import type { Lobe, PuffMesh } from '../shapes.ts';
import { normalized, type Vector } from '../vector.ts';

/** Subdivisions of the icosahedron: 1,280 triangles per lobe, at most 0.3 % of the radius below the sphere. */
export const LOBE_SUBDIVISIONS = 3;

interface Icosphere {
  readonly vertices: readonly Vector[];
  readonly faces: readonly Vector[];
}

function icosahedron(): Icosphere {
  const golden = (1 + Math.sqrt(5)) / 2;
  const corners: Vector[] = [
    [-1, golden, 0], [1, golden, 0], [-1, -golden, 0], [1, -golden, 0],
    [0, -1, golden], [0, 1, golden], [0, -1, -golden], [0, 1, -golden],
    [golden, 0, -1], [golden, 0, 1], [-golden, 0, -1], [-golden, 0, 1],
  ]; // prettier-ignore
  const faces: Vector[] = [
    [0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11],
    [1, 5, 9], [5, 11, 4], [11, 10, 2], [10, 7, 6], [7, 1, 8],
    [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8], [3, 8, 9],
    [4, 9, 5], [2, 4, 11], [6, 2, 10], [8, 6, 7], [9, 8, 1],
  ]; // prettier-ignore
  return { vertices: corners.map(normalized), faces };
}

function subdivided({ vertices, faces }: Icosphere): Icosphere {
  const points = [...vertices];
  const middles = new Map<number, number>();
  const middle = (a: number, b: number): number => {
    const key = Math.min(a, b) * 65536 + Math.max(a, b);
    let index = middles.get(key);
    if (index === undefined) {
      const [p, q] = [points[a], points[b]];
      index = points.push(normalized([p[0] + q[0], p[1] + q[1], p[2] + q[2]])) - 1;
      middles.set(key, index);
    }
    return index;
  };
  const split = faces.flatMap(([a, b, c]): Vector[] => {
    const [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
    return [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]; // prettier-ignore
  });
  return { vertices: points, faces: split };
}

/** A unit sphere of 20 * 4^subdivisions triangles. */
function icosphere(subdivisions: number): Icosphere {
  let sphere = icosahedron();
  for (let i = 0; i < subdivisions; i++) sphere = subdivided(sphere);
  return sphere;
}

/**
 * Builds the mesh of a puff's lobes in its unit space.
 * @param blend weight of the overall normal, 0..1
 */
export function puffMesh(lobes: readonly Lobe[], blend = NORMAL_BLEND, subdivisions = LOBE_SUBDIVISIONS): PuffMesh {
  const sphere = icosphere(subdivisions);
  const middle = middleOf(lobes);
  const positions: number[] = [];
  const normals: number[] = [];
  const indices: number[] = [];
  for (let own = 0; own < lobes.length; own++) {
    const { center, radius } = lobes[own];
    const first = positions.length / 3;
    for (const n of sphere.vertices) {
      const p: Vector = [center[0] + radius * n[0], center[1] + radius * n[1], center[2] + radius * n[2]];
      positions.push(...p);
      normals.push(...softNormal(lobes, middle, p, blend));
    }
    for (const [a, b, c] of sphere.faces) indices.push(first + a, first + b, first + c);
  }
  return {
    positions: Float32Array.from(positions),
    normals: Float32Array.from(normals),
    indices: Uint32Array.from(indices),
  };
}
