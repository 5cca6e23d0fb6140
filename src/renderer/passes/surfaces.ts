import { BackSide, Box3, GLSL3, RawShaderMaterial, type IUniform, type Texture, type WebGLRenderer } from 'three';
import hullFragmentShader from '../../../shaders/surfaces/hull.frag';
import hullVertexShader from '../../../shaders/surfaces/hull.vert';
import raisedFragmentShader from '../../../shaders/surfaces/raised.frag';
import fragmentShader from '../../../shaders/surfaces/surfaces.frag';
import vertexShader from '../../../shaders/surfaces/surfaces.vert';
import { DrawnMesh } from '../gpu/drawnMesh.ts';
import type { FrameView } from '../gpu/frameView.ts';
import type { RampTexture } from '../gpu/ramps.ts';
import type { SurfaceDescription } from './surface.ts';
import { SurfaceGeometry } from './surfaceGeometry.ts';
import type { SurfaceTransforms } from './surfaceTransforms.ts';
import type { Targets } from './targets.ts';

/**
 * Draws the scene's meshes with flat tones, and their outlines as inverted hulls (back faces). Each inked surface has
 * two hulls. One is at the surface's own depth and draws the lines in front of other parts of the surface. The raised
 * one closes the outline where the surface touches another that may move away; the numbers of the groups keep it off
 * the surface's own pixels. The meshes, their hulls and the raised hulls are one draw call each.
 */
export class SurfacesPass {
  private readonly surfaces: DrawnMesh<SurfaceGeometry>;
  private readonly hull: RawShaderMaterial;
  private readonly raisedHull: RawShaderMaterial;
  private readonly groups: IUniform<Texture | null> = { value: null };
  private readonly boxes: Box3[];
  private readonly eye: FrameView;
  private readonly transforms: SurfaceTransforms;

  /** @param firstMaterial ramp index of the first surface; the other surfaces follow in order */
  constructor(
    eye: FrameView,
    ramps: RampTexture,
    firstMaterial: number,
    surfaces: readonly SurfaceDescription[],
    transforms: SurfaceTransforms,
  ) {
    this.eye = eye;
    this.transforms = transforms;
    const placed = { ...eye.uniforms, transforms: { value: transforms.texture } };
    const fill = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader,
      uniforms: { ...placed, ramps: { value: ramps.texture }, firstMaterial: { value: firstMaterial } },
    });
    this.surfaces = new DrawnMesh(fill, new SurfaceGeometry(surfaces));
    this.hull = hullMaterial({ ...placed, isRaised: { value: false } }, hullFragmentShader);
    this.raisedHull = hullMaterial({ ...placed, isRaised: { value: true }, groups: this.groups }, raisedFragmentShader);
    this.boxes = surfaces.map(({ mesh }) => new Box3().setFromArray(mesh.positions));
  }

  /** Whether this frame has raised hulls, which read the numbers of the groups. */
  get isNumbered(): boolean {
    const { geometry } = this;
    return this.eye.uniforms.inkPixels.value > 0 && this.firstRaised < geometry.endInked;
  }

  /** The world-space bounding box of each visible surface. */
  worldBoxes(): Box3[] {
    return this.boxes.flatMap((local, surface) =>
      this.transforms.isVisible(surface) ? [local.clone().applyMatrix4(this.transforms.worldFromModel(surface))] : [],
    );
  }

  /** Replaces the surfaces by others with the same vertices. */
  show(surfaces: readonly SurfaceDescription[]): void {
    this.surfaces.mesh.geometry.show(surfaces);
  }

  /** @param targets bound with the numbers of groups if `isNumbered`; they are bound without them afterwards */
  draw(renderer: WebGLRenderer, targets: Targets): void {
    const { surfaces, geometry, hull, raisedHull, isNumbered } = this;
    this.drawRange(0, geometry.end, renderer, this.eye.variantOf(surfaces.material));
    if (isNumbered) this.groups.value = targets.endNumbers(renderer);
    const { firstInked, endInked } = geometry;
    if (this.eye.uniforms.inkPixels.value > 0) this.drawRange(firstInked, endInked, renderer, hull);
    if (isNumbered) this.drawRange(this.firstRaised, endInked, renderer, raisedHull);
  }

  dispose(): void {
    const { surfaces, hull, raisedHull } = this;
    for (const part of [surfaces.mesh.geometry, surfaces.material, hull, raisedHull]) part.dispose();
  }

  private get geometry(): SurfaceGeometry {
    const { geometry } = this.surfaces.mesh;
    geometry.cullBy(this.transforms);
    return geometry;
  }

  /** The creases pass draws the seams of static surfaces, which then need no raised hull. */
  private get firstRaised(): number {
    const { firstInked, firstMoving } = this.geometry;
    return this.eye.uniforms.creases.value ? firstMoving : firstInked;
  }

  /** Draws the triangles between two corners. */
  private drawRange(start: number, end: number, renderer: WebGLRenderer, material: RawShaderMaterial): void {
    if (start === end) return;
    this.surfaces.mesh.geometry.setDrawRange(start, end - start);
    this.surfaces.drawAs(renderer, material);
  }
}

function hullMaterial(uniforms: Record<string, IUniform>, shader: string): RawShaderMaterial {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: hullVertexShader,
    fragmentShader: shader,
    uniforms,
    side: BackSide,
  });
}
