import {
  BufferAttribute,
  BufferGeometry,
  DataTexture,
  DoubleSide,
  FloatType,
  GLSL3,
  RawShaderMaterial,
  RGBAFormat,
  type IUniform,
  type WebGLRenderer,
} from 'three';
import creasesVertexShader from '../../../shaders/surfaces/creases.vert';
import fragmentShader from '../../../shaders/surfaces/hull.frag';
import { DrawnMesh } from '../gpu/drawnMesh.ts';
import type { FrameView } from '../gpu/frameView.ts';
import { creaseEdges, type CreaseEdges } from './edges/creaseEdges.ts';
import { inOne, type TriangleMesh } from './extrusion.ts';
import { memoize, memoizeWork } from './memoize.ts';
import { seamEdges } from './edges/seamEdges.ts';
import type { SurfaceDescription } from './surface.ts';
import type { SurfaceTransforms } from './surfaceTransforms.ts';
import { SHARP_ANGLE } from '../../base/constants.ts';

/** Edges in a row of the texture, four texels each. */
const EDGES_PER_ROW = 256;

/**
 * Draws the sharp edges of inked surfaces, and the seams between surfaces of the same rigid, as ribbons with the width
 * of the outlines, in one draw call. The depth test hides the covered ones.
 */
export class CreasesPass {
  private readonly eye: FrameView;
  private count = 0;
  private readonly edges: IUniform<DataTexture | null> = { value: null };
  private readonly ribbons: DrawnMesh;

  constructor(eye: FrameView, transforms: SurfaceTransforms) {
    this.eye = eye;
    const material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: creasesVertexShader,
      fragmentShader,
      uniforms: { ...eye.uniforms, edges: this.edges, transforms: { value: transforms.texture } },
      side: DoubleSide,
    });
    this.ribbons = new DrawnMesh(material, new BufferGeometry());
  }

  /** Replaces the surfaces; there are none at first. */
  show(surfaces: readonly SurfaceDescription[]): void {
    const { count, texels, indices } = memoizedRibbons(surfaces);
    const rows = texels.length / (16 * EDGES_PER_ROW);
    this.free();
    this.count = count;
    this.edges.value = new DataTexture(texels, 4 * EDGES_PER_ROW, rows, RGBAFormat, FloatType);
    this.edges.value.needsUpdate = true;
    this.ribbons.mesh.geometry = new BufferGeometry().setIndex(new BufferAttribute(indices, 1));
  }

  draw(renderer: WebGLRenderer): void {
    const { creases, inkPixels } = this.eye.uniforms;
    const isInked = creases.value && inkPixels.value > 0;
    if (this.count > 0 && isInked) this.ribbons.draw(renderer);
  }

  dispose(): void {
    this.free();
    this.ribbons.material.dispose();
  }

  private free(): void {
    this.edges.value?.dispose();
    this.ribbons.mesh.geometry.dispose();
  }
}

export const memoizedCreases = memoizeWork((mesh: TriangleMesh) => creaseEdges(mesh, SHARP_ANGLE));
export const memoizedSeams = memoize((one: TriangleMesh) =>
  memoizeWork((other: TriangleMesh) => seamEdges(one, other)),
);

/** The edges that are drawn with each surface. */
const edgesOf = memoize((surfaces: readonly SurfaceDescription[]) =>
  surfaces.map(({ inked, skin, mesh }, index) =>
    joined(
      inked && !skin
        ? [memoizedCreases(mesh), ...meetingBehind(surfaces, index).map((other) => memoizedSeams(mesh)(other.mesh))]
        : [],
    ),
  ),
);

/**
 * The surfaces that have seams with a surface: later inked ones on the same rigid or part, except those of its group.
 */
export function meetingBehind(surfaces: readonly SurfaceDescription[], index: number): SurfaceDescription[] {
  const { rigid, part, group } = surfaces[index];
  return surfaces
    .slice(index + 1)
    .filter(
      (other) =>
        other.inked &&
        !other.skin &&
        other.rigid === rigid &&
        other.part === part &&
        (group === undefined || other.group !== group),
    );
}

function joined(edges: readonly CreaseEdges[]): CreaseEdges {
  return {
    count: edges.reduce((sum, { count }) => sum + count, 0),
    ends: inOne(edges.map(({ ends }) => ends)),
    faceNormals: inOne(edges.map(({ faceNormals }) => faceNormals)),
  };
}

/** The edges of all surfaces as texels, and two triangles for each; the texture has at least one row. */
export const memoizedRibbons = memoize((surfaces: readonly SurfaceDescription[]) => {
  const all = edgesOf(surfaces);
  const count = all.reduce((sum, edges) => sum + edges.count, 0);
  const texels = new Float32Array(16 * EDGES_PER_ROW * Math.max(1, Math.ceil(count / EDGES_PER_ROW)));
  let at = 0;
  all.forEach(({ count: own, ends, faceNormals }, surface) => {
    for (let first = 0; first < 6 * own; first += 6) {
      texels.set(ends.subarray(first, first + 3), at);
      texels[at + 3] = surface;
      texels.set(ends.subarray(first + 3, first + 6), at + 4);
      texels.set(faceNormals.subarray(first, first + 3), at + 8);
      texels.set(faceNormals.subarray(first + 3, first + 6), at + 12);
      at += 16;
    }
  });
  const corners = [0, 1, 2, 0, 2, 3];
  const indices = Uint32Array.from({ length: 6 * count }, (_, index) => 4 * Math.floor(index / 6) + corners[index % 6]);
  return { count, texels, indices };
});
