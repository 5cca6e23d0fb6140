import { BufferAttribute, BufferGeometry } from 'three';
import { hullNormals, inOne } from './extrusion.ts';
import { memoize } from './memoize.ts';
import { groupOf, isMoving, type SurfaceDescription } from './surface.ts';

export const memoizedHullNormals = memoize(hullNormals);

/** Largest number of a group. Numbers repeat after it, so two groups may share one. */
const GROUPS = 255;

/**
 * Vertices and triangles of all surfaces of a scene. The inked static ones are followed by the inked moving ones, so that
 * each set that a draw call needs is one range. Of two surfaces at the same depth, the later one is visible: inked ones
 * cover static ones without outlines, and moving ones without outlines cover both.
 */
export class SurfaceGeometry extends BufferGeometry {
  /** First corner of inked surfaces, first corner of those that move, and the corner after the last one. */
  readonly firstInked: number;
  readonly firstMoving: number;
  readonly endInked: number;

  constructor(surfaces: readonly SurfaceDescription[]) {
    super();
    const { positions, normals, outward, numbers, indices, ends } = arraysOf(surfaces);
    this.setAttribute('position', new BufferAttribute(positions, 3));
    this.setAttribute('normal', new BufferAttribute(normals, 3));
    this.setAttribute('hullNormal', new BufferAttribute(outward, 3));
    this.setAttribute('surfaceAndGroup', new BufferAttribute(numbers, 2));
    this.setIndex(new BufferAttribute(indices, 1));
    [this.firstInked, this.firstMoving, this.endInked] = ends;
  }
}

/** The position of a surface in drawing order. */
function setOf(surface: SurfaceDescription): number {
  if (surface.inked) return isMoving(surface) ? 2 : 1;
  return isMoving(surface) ? 3 : 0;
}

/** Vertices in the order of the surfaces, triangles in drawing order. */
const arraysOf = memoize((surfaces: readonly SurfaceDescription[]) => {
  const meshes = surfaces.map(({ mesh }) => mesh);
  const firstVertices = [0];
  for (const { positions } of meshes) firstVertices.push(firstVertices.at(-1)! + positions.length / 3);
  const groups = surfaces.map(groupOf);
  const names = [...new Set(groups)];
  const numbers = new Float32Array(2 * firstVertices.at(-1)!);
  meshes.forEach((_, surface) => {
    const group = 1 + (names.indexOf(groups[surface]) % GROUPS);
    for (let vertex = firstVertices[surface]; vertex < firstVertices[surface + 1]; vertex++) {
      numbers.set([surface, group], 2 * vertex);
    }
  });
  const indices = new Uint32Array(meshes.reduce((sum, mesh) => sum + mesh.indices.length, 0));
  const ends: number[] = [];
  let end = 0;
  for (const set of [0, 1, 2, 3]) {
    meshes.forEach((mesh, surface) => {
      if (setOf(surfaces[surface]) !== set) return;
      for (const vertex of mesh.indices) indices[end++] = firstVertices[surface] + vertex;
    });
    ends.push(end);
  }
  return {
    positions: inOne(meshes.map(({ positions }) => positions)),
    normals: inOne(meshes.map(({ normals }) => normals)),
    outward: inOne(meshes.map(memoizedHullNormals)),
    numbers,
    indices,
    ends,
  };
});
