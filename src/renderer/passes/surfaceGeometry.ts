import { BufferAttribute, BufferGeometry, DynamicDrawUsage } from 'three';
import { hullNormals, inOne } from './extrusion.ts';
import { memoize } from './memoize.ts';
import type { SurfaceTransforms } from './surfaceTransforms.ts';
import { groupOf, isMoving, type SurfaceDescription } from './surface.ts';

export const memoizedHullNormals = memoize(hullNormals);

/** Largest number of a group. Numbers repeat after it, so two groups may share one. */
const GROUPS = 255;

/**
 * Vertices of all surfaces of a scene, and the triangles of the visible ones. The inked static ones are followed by the
 * inked moving ones, so that each set that a draw call needs is one range. Of two surfaces at the same depth, the later
 * one is visible: inked ones cover static ones without outlines, and moving ones without outlines cover both.
 */
export class SurfaceGeometry extends BufferGeometry {
  /** First corner of inked surfaces, first corner of those that move, the corner after them, and that after the last. */
  firstInked = 0;
  firstMoving = 0;
  endInked = 0;
  end = 0;
  private surfaces: readonly SurfaceDescription[];
  private readonly firstVertices: readonly number[];
  private readonly indices: BufferAttribute;
  /** Of the transforms, when the triangles were written. */
  private changes = -1;

  constructor(surfaces: readonly SurfaceDescription[]) {
    super();
    const { positions, normals, outward, numbers, firstVertices, corners } = memoizedVertices(surfaces);
    this.surfaces = surfaces;
    this.firstVertices = firstVertices;
    this.setAttribute('position', new BufferAttribute(positions, 3));
    this.setAttribute('normal', new BufferAttribute(normals, 3));
    this.setAttribute('hullNormal', new BufferAttribute(outward, 3));
    this.setAttribute('surfaceGroupRow', new BufferAttribute(numbers, 3));
    this.indices = new BufferAttribute(new Uint32Array(corners), 1).setUsage(DynamicDrawUsage);
    this.setIndex(this.indices);
  }

  /** Replaces the surfaces by others with the same vertices. */
  show(surfaces: readonly SurfaceDescription[]): void {
    this.surfaces = surfaces;
    this.changes = -1;
  }

  /** Writes the triangles again if they were replaced, or if a surface has appeared or disappeared. */
  cullBy(transforms: SurfaceTransforms): void {
    if (this.changes === transforms.changes) return;
    this.changes = transforms.changes;
    const { surfaces, firstVertices, indices } = this;
    let end = 0;
    const ends = [0, 1, 2, 3].map((set) => {
      surfaces.forEach((surface, index) => {
        if (!transforms.isVisible(index) || setOf(surface) !== set) return;
        for (const vertex of surface.mesh.indices) indices.array[end++] = firstVertices[index] + vertex;
      });
      return end;
    });
    [this.firstInked, this.firstMoving, this.endInked, this.end] = ends;
    indices.clearUpdateRanges();
    indices.addUpdateRange(0, end);
    indices.needsUpdate = true;
  }
}

/** The position of a surface in drawing order; -1 for a hidden one. */
function setOf(surface: SurfaceDescription): number {
  if (surface.hidden) return -1;
  if (surface.inked) return isMoving(surface) ? 2 : 1;
  return isMoving(surface) ? 3 : 0;
}

/** The vertices of surfaces. */
export const memoizedVertices = memoize((surfaces: readonly SurfaceDescription[]) => {
  const meshes = surfaces.map(({ mesh }) => mesh);
  const firstVertices = [0];
  for (const { positions } of meshes) firstVertices.push(firstVertices.at(-1)! + positions.length / 3);
  const groups = surfaces.map(groupOf);
  const names = [...new Set(groups)];
  const numbers = new Float32Array(3 * firstVertices.at(-1)!);
  surfaces.forEach(({ skin }, surface) => {
    const group = 1 + (names.indexOf(groups[surface]) % GROUPS);
    for (let vertex = firstVertices[surface]; vertex < firstVertices[surface + 1]; vertex++) {
      numbers[3 * vertex] = surface;
      numbers[3 * vertex + 1] = group;
      numbers[3 * vertex + 2] = skin ? surfaces.length + skin[vertex - firstVertices[surface]] : surface;
    }
  });
  return {
    positions: inOne(meshes.map(({ positions }) => positions)),
    normals: inOne(meshes.map(({ normals }) => normals)),
    outward: inOne(meshes.map(memoizedHullNormals)),
    numbers,
    firstVertices,
    corners: meshes.reduce((sum, mesh) => sum + mesh.indices.length, 0),
  };
});
