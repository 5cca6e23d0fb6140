import {
  BackSide,
  Box3,
  BufferAttribute,
  BufferGeometry,
  GLSL3,
  Mesh,
  NotEqualStencilFunc,
  RawShaderMaterial,
  ReplaceStencilOp,
  Scene,
  type Matrix4,
  type WebGLRenderer,
} from 'three';
import { PassCamera } from '../device/passCamera.ts';
import hullFragmentShader from '../../shaders/surfaces/hull.frag';
import hullVertexShader from '../../shaders/surfaces/hull.vert';
import fragmentShader from '../../shaders/surfaces/surfaces.frag';
import vertexShader from '../../shaders/surfaces/surfaces.vert';
import type { FrameView } from '../device/frameView.ts';
import type { Color, RampTexture } from '../device/ramps.ts';
import { hullNormals, type TriangleMesh } from './extrusion.ts';
import { memoize } from './memoize.ts';

/** A triangle mesh of the scene. */
export interface SurfaceDescription {
  name: string;
  mesh: TriangleMesh;
  /** Colour in full light. */
  color: Color;
  /** Whether it casts shadows. The mesh must be closed then. */
  casts: boolean;
  /** Whether it has outlines. */
  inked: boolean;
  /**
   * Surfaces of the same group have no line between them. A surface without a group has outlines against all others.
   */
  group?: string;
  /** Index of the rigid that it is attached to; static if absent. */
  rigid?: number;
  /** Index of the scene part whose transform it has, instead of a rigid. */
  part?: number;
}

/**
 * Draws the scene's meshes with flat tones, and their outlines as inverted hulls (back faces). Each inked surface has
 * two hulls. One is at the surface's own depth and draws the lines in front of other parts of the surface. The raised
 * one closes the outline where the surface touches another that may move away; the stencil test keeps it off the
 * surface's own pixels. The stencil is zero before and after.
 */
export class SurfacesPass {
  private readonly fills = new Scene();
  private readonly hulls = new Scene();
  private readonly camera = new PassCamera();
  private readonly materials: RawShaderMaterial[] = [];
  private readonly geometries: BufferGeometry[] = [];
  private readonly placed: Mesh[][] = [];
  /** The raised hulls of static surfaces. */
  private readonly closing: Mesh[] = [];
  private readonly groups = new Map<string, number>();
  private readonly boxes: Box3[];
  private readonly eye: FrameView;

  /** @param firstMaterial ramp index of the first surface; the other surfaces follow in order */
  constructor(eye: FrameView, ramps: RampTexture, firstMaterial: number, surfaces: readonly SurfaceDescription[]) {
    this.eye = eye;
    surfaces.forEach((surface, index) => this.add(surface, ramps, firstMaterial + index));
    this.boxes = surfaces.map((surface) => boxOf(surface.mesh));
  }

  /** Sets the world transform and the visibility of a surface. */
  place(surface: number, worldFromModel: Matrix4, isVisible = true): void {
    for (const mesh of this.placed[surface]) {
      mesh.matrixWorld.copy(worldFromModel);
      mesh.visible = isVisible;
    }
  }

  /** The world-space bounding box of each visible surface. */
  worldBoxes(): Box3[] {
    return this.boxes.flatMap((local, surface) => {
      const [{ visible, matrixWorld }] = this.placed[surface];
      return visible ? [local.clone().applyMatrix4(matrixWorld)] : [];
    });
  }

  draw(renderer: WebGLRenderer): void {
    const { creases, inkPixels } = this.eye.uniforms;
    // The creases pass draws the seams of static surfaces, which then need no raised hull.
    for (const hull of this.closing) hull.visible = !creases.value;
    renderer.render(this.fills, this.camera);
    if (inkPixels.value > 0) renderer.render(this.hulls, this.camera);
    renderer.clearStencil();
  }

  dispose(): void {
    for (const material of this.materials) material.dispose();
    for (const geometry of this.geometries) geometry.dispose();
  }

  private add(surface: SurfaceDescription, ramps: RampTexture, ramp: number): void {
    const ownPixels = this.stencilNumber(surface);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(surface.mesh.positions, 3));
    geometry.setAttribute('normal', new BufferAttribute(surface.mesh.normals, 3));
    geometry.setAttribute('hullNormal', new BufferAttribute(memoizedHullNormals(surface.mesh), 3));
    geometry.setIndex(new BufferAttribute(surface.mesh.indices, 1));
    const material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader,
      uniforms: {
        ...this.eye.uniforms,
        ramps: { value: ramps.texture },
        material: { value: ramp },
      },
      stencilWrite: true,
      stencilRef: ownPixels,
      stencilZPass: ReplaceStencilOp,
    });
    this.geometries.push(geometry);
    const meshes = [this.mesh(this.fills, geometry, material)];
    if (surface.inked) {
      meshes.push(this.mesh(this.hulls, geometry, this.hull(0)));
      const raised = this.mesh(this.hulls, geometry, this.hull(ownPixels));
      if (surface.rigid === undefined && surface.part === undefined) this.closing.push(raised);
      meshes.push(raised);
    }
    this.placed.push(meshes);
  }

  /**
   * The stencil value 1..255 of a surface or of its group. Values repeat after 255 groups, so two groups may share one.
   */
  private stencilNumber({ group, name }: SurfaceDescription): number {
    const key = group ?? `${name} ${this.placed.length}`;
    if (!this.groups.has(key)) this.groups.set(key, 1 + (this.groups.size % 255));
    return this.groups.get(key)!;
  }

  /** @param ownPixels the stencil value that the line must not cover; 0 for the hull that is not raised */
  private hull(ownPixels: number): RawShaderMaterial {
    return new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: hullVertexShader,
      fragmentShader: hullFragmentShader,
      uniforms: { ...this.eye.uniforms, isRaised: { value: ownPixels > 0 } },
      side: BackSide,
      stencilWrite: ownPixels > 0,
      stencilRef: ownPixels,
      stencilFunc: NotEqualStencilFunc,
    });
  }

  private mesh(scene: Scene, geometry: BufferGeometry, material: RawShaderMaterial): Mesh {
    this.materials.push(material);
    const mesh = new Mesh(geometry, material);
    mesh.frustumCulled = false;
    mesh.matrixAutoUpdate = false;
    mesh.matrixWorldAutoUpdate = false;
    scene.add(mesh);
    return mesh;
  }
}

export const memoizedHullNormals = memoize(hullNormals);

function boxOf(mesh: TriangleMesh): Box3 {
  return new Box3().setFromArray(mesh.positions);
}
