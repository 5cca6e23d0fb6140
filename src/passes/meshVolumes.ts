import {
  BufferAttribute,
  BufferGeometry,
  Mesh,
  type RawShaderMaterial,
  Scene,
  type Matrix4,
  type WebGLRenderer,
} from 'three';
import { PassCamera } from '../device/passCamera.ts';
import fragmentShader from '../../shaders/meshVolumes/meshVolumes.frag';
import vertexShader from '../../shaders/meshVolumes/meshVolumes.vert';
import type { FrameView } from '../device/frameView.ts';
import { countFaces, countingMaterial } from '../device/stencil.ts';
import { extrude } from './extrusion.ts';
import { memoize } from './memoize.ts';
import type { SurfaceDescription } from './surfaces.ts';
import { SHADOW_INSET } from '../constants.ts';

export const memoizedExtrusion = memoize(extrude);

/**
 * Counts the shadow volumes of closed meshes by depth fail, which is correct even if the camera is inside a volume.
 * Triangles of a mesh come in any order, so the stencil operations wrap. This pass must run before the volumes of
 * particles, which clamp: the count of meshes over a pixel must stay below 256.
 */
export class MeshVolumesPass {
  private readonly scene = new Scene();
  private readonly camera = new PassCamera();
  private readonly meshes = new Map<number, Mesh<BufferGeometry, RawShaderMaterial>>();

  constructor(eye: FrameView, surfaces: readonly SurfaceDescription[]) {
    surfaces.forEach((surface, index) => {
      if (surface.casts) this.add(eye, surface, index);
    });
  }

  /** Sets the world transform and the visibility of a surface. */
  place(surface: number, worldFromModel: Matrix4, isVisible = true): void {
    const mesh = this.meshes.get(surface);
    if (!mesh) return;
    mesh.matrixWorld.copy(worldFromModel);
    mesh.visible = isVisible;
  }

  draw(renderer: WebGLRenderer): void {
    if (this.meshes.size > 0) renderer.render(this.scene, this.camera);
  }

  dispose(): void {
    for (const { geometry, material } of this.meshes.values()) {
      geometry.dispose();
      material.dispose();
    }
  }

  private add(eye: FrameView, surface: SurfaceDescription, index: number): void {
    const { positions, faceNormals, indices, longestEdge } = memoizedExtrusion(surface.mesh);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    geometry.setAttribute('faceNormal', new BufferAttribute(faceNormals, 3));
    geometry.setIndex(new BufferAttribute(indices, 1));
    const material = countingMaterial({
      vertexShader,
      fragmentShader,
      uniforms: { ...eye.uniforms, inset: { value: SHADOW_INSET }, longestEdge: { value: longestEdge } },
    });
    const mesh = new Mesh(geometry, material);
    mesh.frustumCulled = false;
    mesh.matrixAutoUpdate = false;
    mesh.matrixWorldAutoUpdate = false;
    countFaces(
      mesh,
      { depthFail: WebGL2RenderingContext.DECR_WRAP, depthPass: WebGL2RenderingContext.KEEP },
      { depthFail: WebGL2RenderingContext.INCR_WRAP, depthPass: WebGL2RenderingContext.KEEP },
    );
    this.meshes.set(index, mesh);
    this.scene.add(mesh);
  }
}
