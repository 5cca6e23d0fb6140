import {
  BackSide,
  Box3,
  GLSL3,
  NotEqualStencilFunc,
  RawShaderMaterial,
  ReplaceStencilOp,
  type IUniform,
  type WebGLRenderer,
} from 'three';
import hullFragmentShader from '../../shaders/surfaces/hull.frag';
import hullVertexShader from '../../shaders/surfaces/hull.vert';
import fragmentShader from '../../shaders/surfaces/surfaces.frag';
import vertexShader from '../../shaders/surfaces/surfaces.vert';
import type { FrameView } from '../device/frameView.ts';
import type { RampTexture } from '../device/ramps.ts';
import { groupOf, isMoving, type SurfaceDescription } from './surface.ts';
import { SurfaceGeometry, type SurfaceRuns } from './surfaceRuns.ts';
import type { SurfaceTransforms } from './surfaceTransforms.ts';

/**
 * Draws the scene's meshes with flat tones, and their outlines as inverted hulls (back faces). Each inked surface has
 * two hulls. One is at the surface's own depth and draws the lines in front of other parts of the surface. The raised
 * one closes the outline where the surface touches another that may move away; the stencil test keeps it off the
 * surface's own pixels. The stencil is zero before and after. Surfaces with the same stencil number are one draw call.
 */
export class SurfacesPass {
  private readonly fill: RawShaderMaterial;
  private readonly hull: RawShaderMaterial;
  private readonly raisedHull: RawShaderMaterial;
  private readonly hulls: SurfaceRuns;
  /** The creases pass draws the seams of static surfaces, which then need no raised hull. */
  private readonly withCreases: NumberedRuns;
  private readonly withoutCreases: NumberedRuns;
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
    this.fill = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader,
      uniforms: { ...placed, ramps: { value: ramps.texture }, firstMaterial: { value: firstMaterial } },
      stencilWrite: true,
      stencilZPass: ReplaceStencilOp,
    });
    this.hull = hullMaterial(placed, false);
    this.raisedHull = hullMaterial(placed, true);
    const geometry = new SurfaceGeometry(surfaces);
    const isInked = surfaces.map(({ inked }) => inked);
    this.hulls = geometry.runs(this.hull, (surface) => (isInked[surface] ? 0 : undefined));
    const runsOf = (hasCreases: boolean): NumberedRuns => {
      const isRaised = surfaces.map((surface) => surface.inked && (isMoving(surface) || !hasCreases));
      const numbers = stencilNumbers(surfaces, isRaised);
      return {
        fills: geometry.runs(this.fill, (surface) => numbers[surface]),
        raised: geometry.runs(this.raisedHull, (surface) => (isRaised[surface] ? numbers[surface] : undefined)),
      };
    };
    this.withCreases = runsOf(true);
    this.withoutCreases = runsOf(false);
    this.boxes = surfaces.map(({ mesh }) => new Box3().setFromArray(mesh.positions));
  }

  /** The world-space bounding box of each visible surface. */
  worldBoxes(): Box3[] {
    return this.boxes.flatMap((local, surface) =>
      this.transforms.isVisible(surface) ? [local.clone().applyMatrix4(this.transforms.worldFromModel(surface))] : [],
    );
  }

  draw(renderer: WebGLRenderer): void {
    const { creases, inkPixels } = this.eye.uniforms;
    const { fills, raised } = creases.value ? this.withCreases : this.withoutCreases;
    fills.draw(renderer);
    if (inkPixels.value > 0) {
      this.hulls.draw(renderer);
      raised.draw(renderer);
    }
    renderer.clearStencil();
  }

  dispose(): void {
    const { withCreases, withoutCreases } = this;
    for (const { fills, raised } of [withCreases, withoutCreases]) for (const runs of [fills, raised]) runs.dispose();
    for (const part of [this.hulls, this.fill, this.hull, this.raisedHull]) part.dispose();
  }
}

/** Fills, which write the stencil number of their surface, and raised hulls, which avoid it. */
interface NumberedRuns {
  readonly fills: SurfaceRuns;
  readonly raised: SurfaceRuns;
}

/**
 * The stencil number of each surface: 1..255 for its group if that has a raised hull, else 0. Numbers repeat after 255
 * groups, so two groups may share one.
 */
function stencilNumbers(surfaces: readonly SurfaceDescription[], isRaised: readonly boolean[]): number[] {
  const groups = surfaces.map(groupOf);
  const numbered = [...new Set(groups.filter((_, surface) => isRaised[surface]))];
  return groups.map((group) => (numbered.includes(group) ? 1 + (numbered.indexOf(group) % 255) : 0));
}

function hullMaterial(uniforms: Record<string, IUniform>, isRaised: boolean): RawShaderMaterial {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: hullVertexShader,
    fragmentShader: hullFragmentShader,
    uniforms: { ...uniforms, isRaised: { value: isRaised } },
    side: BackSide,
    stencilWrite: isRaised,
    stencilFunc: NotEqualStencilFunc,
  });
}
