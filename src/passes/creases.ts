import {
  DoubleSide,
  GLSL3,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  BufferAttribute,
  Mesh,
  RawShaderMaterial,
  Scene,
  type Matrix4,
  type WebGLRenderer,
} from 'three';
import { PassCamera } from '../device/passCamera.ts';
import creasesVertexShader from '../../shaders/surfaces/creases.vert';
import fragmentShader from '../../shaders/surfaces/hull.frag';
import type { FrameView } from '../device/frameView.ts';
import { creaseEdges, type CreaseEdges } from './creaseEdges.ts';
import { inOne, type TriangleMesh } from './extrusion.ts';
import { memoize } from './memoize.ts';
import { seamEdges } from './seamEdges.ts';
import type { SurfaceDescription } from './surfaces.ts';
import { SHARP_ANGLE } from '../constants.ts';

/**
 * Draws the sharp edges of inked surfaces, and the seams between surfaces of the same rigid, as ribbons with the width
 * of the outlines. The depth test hides the covered ones.
 */
export class CreasesPass {
  private readonly scene = new Scene();
  private readonly camera = new PassCamera();
  private readonly meshes = new Map<number, Mesh<InstancedBufferGeometry, RawShaderMaterial>>();
  private readonly eye: FrameView;
  private readonly material: RawShaderMaterial;

  constructor(eye: FrameView, surfaces: readonly SurfaceDescription[]) {
    this.eye = eye;
    this.material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: creasesVertexShader,
      fragmentShader,
      uniforms: eye.uniforms,
      side: DoubleSide,
    });
    edgesOf(surfaces).forEach((edges, index) => this.add(index, edges));
  }

  /** Sets the world transform and the visibility of a surface. */
  place(surface: number, worldFromModel: Matrix4, isVisible = true): void {
    const ribbons = this.meshes.get(surface);
    if (!ribbons) return;
    ribbons.matrixWorld.copy(worldFromModel);
    ribbons.visible = isVisible;
  }

  draw(renderer: WebGLRenderer): void {
    const { creases, inkPixels } = this.eye.uniforms;
    const isInked = creases.value && inkPixels.value > 0;
    if (this.meshes.size > 0 && isInked) renderer.render(this.scene, this.camera);
  }

  dispose(): void {
    this.material.dispose();
    for (const { geometry } of this.meshes.values()) geometry.dispose();
  }

  private add(index: number, edges: CreaseEdges): void {
    if (edges.count === 0) return;
    const ribbons = new Mesh(ribbonsOf(edges), this.material);
    ribbons.frustumCulled = false;
    ribbons.matrixAutoUpdate = false;
    ribbons.matrixWorldAutoUpdate = false;
    this.meshes.set(index, ribbons);
    this.scene.add(ribbons);
  }
}

export const memoizedCreases = memoize((mesh: TriangleMesh) => creaseEdges(mesh, SHARP_ANGLE));
export const memoizedSeams = memoize((one: TriangleMesh) => memoize((other: TriangleMesh) => seamEdges(one, other)));

/** The edges that are drawn with each surface. */
const edgesOf = memoize((surfaces: readonly SurfaceDescription[]) =>
  surfaces.map(({ inked, mesh }, index) =>
    joined(
      inked
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
        other.inked && other.rigid === rigid && other.part === part && (group === undefined || other.group !== group),
    );
}

function joined(edges: readonly CreaseEdges[]): CreaseEdges {
  return {
    count: edges.reduce((sum, { count }) => sum + count, 0),
    ends: inOne(edges.map(({ ends }) => ends)),
    faceNormals: inOne(edges.map(({ faceNormals }) => faceNormals)),
  };
}

/** An instanced geometry with one quad for each edge. */
function ribbonsOf({ count, ends, faceNormals }: CreaseEdges): InstancedBufferGeometry {
  const geometry = new InstancedBufferGeometry();
  const everyOther = (numbers: Float32Array, first: number): InstancedBufferAttribute =>
    new InstancedBufferAttribute(
      numbers.filter((_, at) => at % 6 >= first && at % 6 < first + 3),
      3,
    );
  geometry.setAttribute('corner', new BufferAttribute(new Float32Array([0, -1, 1, -1, 1, 1, 0, 1]), 2));
  geometry.setAttribute('start', everyOther(ends, 0));
  geometry.setAttribute('end', everyOther(ends, 3));
  geometry.setAttribute('oneNormal', everyOther(faceNormals, 0));
  geometry.setAttribute('otherNormal', everyOther(faceNormals, 3));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  geometry.instanceCount = count;
  return geometry;
}
