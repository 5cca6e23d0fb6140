import {
  BufferAttribute,
  BufferGeometry,
  Mesh,
  Scene,
  type GeometryGroup,
  type RawShaderMaterial,
  type WebGLRenderer,
} from 'three';
import { PassCamera } from '../device/passCamera.ts';
import { hullNormals, inOne } from './extrusion.ts';
import { memoize } from './memoize.ts';
import { groupOf, isMoving, type SurfaceDescription } from './surface.ts';

export const memoizedHullNormals = memoize(hullNormals);

/** Vertices and triangles of all surfaces of a scene, in an order in which few draw calls suffice. */
export class SurfaceGeometry {
  private readonly attributes: Readonly<Record<string, BufferAttribute>>;
  private readonly index: BufferAttribute;
  /** Indices of the surfaces in drawing order. */
  private readonly order: readonly number[];
  private readonly surfaces: readonly SurfaceDescription[];

  constructor(surfaces: readonly SurfaceDescription[]) {
    this.surfaces = surfaces;
    this.order = orderOf(surfaces);
    const { positions, normals, outward, surfaces: numbers, indices } = arraysOf(surfaces);
    this.attributes = {
      position: new BufferAttribute(positions, 3),
      normal: new BufferAttribute(normals, 3),
      hullNormal: new BufferAttribute(outward, 3),
      surface: new BufferAttribute(numbers, 1),
    };
    this.index = new BufferAttribute(indices, 1);
  }

  /**
   * A draw call for each run of surfaces with the same stencil number.
   * @param numberOf stencil number of a surface; undefined if it is not drawn
   */
  runs(material: RawShaderMaterial, numberOf: (surface: number) => number | undefined): SurfaceRuns {
    const geometry = new BufferGeometry();
    for (const [name, attribute] of Object.entries(this.attributes)) geometry.setAttribute(name, attribute);
    geometry.setIndex(this.index);
    const numbers: number[] = [];
    let end = 0;
    for (const surface of this.order) {
      const { length } = this.surfaces[surface].mesh.indices;
      const number = numberOf(surface);
      const last = geometry.groups.at(-1);
      if (number !== undefined && last && last.start + last.count === end && numbers.at(-1) === number) {
        last.count += length;
      } else if (number !== undefined) {
        geometry.addGroup(end, length, numbers.length);
        numbers.push(number);
      }
      end += length;
    }
    return new SurfaceRuns(geometry, material, numbers);
  }
}

/** Draw calls of one material. Each sets the reference value of its stencil test. */
export class SurfaceRuns {
  private readonly scene = new Scene();
  private readonly camera = new PassCamera();
  private readonly geometry: BufferGeometry;

  /** @param numbers a stencil number for each group of the geometry */
  constructor(geometry: BufferGeometry, material: RawShaderMaterial, numbers: readonly number[]) {
    this.geometry = geometry;
    const mesh = new Mesh(
      geometry,
      numbers.map(() => material),
    );
    mesh.frustumCulled = false;
    mesh.onBeforeRender = (...drawn) => {
      // three.js passes a group of the geometry; its types name the scene object of that name.
      const { materialIndex } = drawn[5] as unknown as GeometryGroup;
      material.stencilRef = numbers[materialIndex!];
    };
    this.scene.add(mesh);
  }

  draw(renderer: WebGLRenderer): void {
    renderer.render(this.scene, this.camera);
  }

  dispose(): void {
    this.geometry.dispose();
  }
}

/** Static surfaces come first. Surfaces of a group follow each other, and so do those with outlines. */
function orderOf(surfaces: readonly SurfaceDescription[]): number[] {
  const groups = surfaces.map(groupOf);
  const key = (surface: number) => {
    const { inked } = surfaces[surface];
    return isMoving(surfaces[surface]) ? [1, groups.indexOf(groups[surface]), Number(inked)] : [0, Number(inked), 0];
  };
  const keys = surfaces.map((_, surface) => key(surface));
  return surfaces
    .map((_, surface) => surface)
    .sort((a, b) => keys[a][0] - keys[b][0] || keys[a][1] - keys[b][1] || keys[a][2] - keys[b][2] || a - b);
}

/** Vertices in the order of the surfaces, triangles in drawing order. */
const arraysOf = memoize((surfaces: readonly SurfaceDescription[]) => {
  const meshes = surfaces.map(({ mesh }) => mesh);
  const firstVertices = [0];
  for (const { positions } of meshes) firstVertices.push(firstVertices.at(-1)! + positions.length / 3);
  const indices = new Uint32Array(meshes.reduce((sum, mesh) => sum + mesh.indices.length, 0));
  let end = 0;
  for (const surface of orderOf(surfaces)) {
    for (const vertex of meshes[surface].indices) indices[end++] = firstVertices[surface] + vertex;
  }
  return {
    positions: inOne(meshes.map(({ positions }) => positions)),
    normals: inOne(meshes.map(({ normals }) => normals)),
    outward: inOne(meshes.map(memoizedHullNormals)),
    surfaces: inOne(meshes.map(({ positions }, surface) => new Float32Array(positions.length / 3).fill(surface))),
    indices,
  };
});
