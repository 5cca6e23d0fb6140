import { BufferAttribute, BufferGeometry } from 'three';
import { hullNormals, inOne } from './extrusion.ts';
import { memoize } from './memoize.ts';
import { groupOf, isMoving, type SurfaceDescription } from './surface.ts';

export const memoizedHullNormals = memoize(hullNormals);

/** Largest number of a group. Numbers repeat after it, so two groups may share one. */
const GROUPS = 255;

/**
 * Vertices and triangles of all surfaces of a scene. Those without outlines come first, then the inked static ones,
 * then the inked moving ones, so that each set that a draw call needs is the rest of the triangles.
 */
export class SurfaceGeometry extends BufferGeometry {
  /** Index of the first corner of inked surfaces, and of inked surfaces that move. */
  readonly firstInked: number;
  readonly firstMoving: number;

  constructor(surfaces: readonly SurfaceDescription[]) {
    super();
    const { positions, normals, outward, numbers, indices, firstInked, firstMoving } = arraysOf(surfaces);
    this.setAttribute('position', new BufferAttribute(positions, 3));
    this.setAttribute('normal', new BufferAttribute(normals, 3));
    this.setAttribute('hullNormal', new BufferAttribute(outward, 3));
    this.setAttribute('surfaceAndGroup', new BufferAttribute(numbers, 2));
    this.setIndex(new BufferAttribute(indices, 1));
    this.firstInked = firstInked;
    this.firstMoving = firstMoving;
  }

  /** Number of all corners. */
  get corners(): number {
    return this.index!.count;
  }
}

/** 0 without outlines, 1 static with outlines, 2 moving with outlines. */
function setOf(surface: SurfaceDescription): number {
  return surface.inked ? 1 + Number(isMoving(surface)) : 0;
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
  const firsts: number[] = [];
  let end = 0;
  for (const set of [0, 1, 2]) {
    firsts.push(end);
    meshes.forEach((mesh, surface) => {
      if (setOf(surfaces[surface]) !== set) return;
      for (const vertex of mesh.indices) indices[end++] = firstVertices[surface] + vertex;
    });
  }
  return {
    positions: inOne(meshes.map(({ positions }) => positions)),
    normals: inOne(meshes.map(({ normals }) => normals)),
    outward: inOne(meshes.map(memoizedHullNormals)),
    numbers,
    indices,
    firstInked: firsts[1],
    firstMoving: firsts[2],
  };
});
