import {
  DoubleSide,
  GLSL3,
  RawShaderMaterial,
  Vector2,
  Vector3,
  Vector4,
  type BufferGeometry,
  type IUniform,
  type Texture,
  type WebGLRenderer,
} from 'three';
import lobesFragmentShader from '../../shaders/bodies/lobes.frag';
import lobesVertexShader from '../../shaders/bodies/lobes.vert';
import { DrawnMesh } from '../device/drawnMesh.ts';
import type { FrameView } from '../device/frameView.ts';
import type { Shaders } from '../device/programsAhead.ts';
import type { PuffTextures } from '../device/puffTextures.ts';
import type { Color, RampTexture } from '../device/ramps.ts';
import { withLobes } from '../device/unroll.ts';
import type { SurfaceDepthPass } from './surfaceDepth.ts';
import { InkUniforms, type InkLine } from './ink.ts';

/** What runs along a gradient fill. */
export type Gradient = 'none' | 'puff' | 'height' | 'screen' | 'age';

const NO_SURFACES = { surfaceDepth: { value: null }, hasSurfaces: { value: false }, surfaceSlack: { value: 0 } };

/** Draws the bodies: colour in light and in shadow, ink, and depth. Opaque and free of any order. */
export class BodiesPass {
  private readonly rows: DrawnMesh;
  /** By the number of lobes that are unrolled in them; the billboards' by 0. */
  private readonly materials = new Map<number, RawShaderMaterial>();
  private readonly puffs: PuffTextures;
  private readonly isFlat: boolean;
  private readonly common: Record<string, IUniform>;
  private readonly ink = new InkUniforms();
  private readonly uniforms = {
    innerLine: { value: 0.5 },
    innerTaper: { value: 0 },
    boil: { value: 0 },
    drawing: { value: 0 },
    heights: { value: new Vector2() },
    gradientWeights: { value: new Vector3() },
    gradientFactor: { value: new Vector3(1, 1, 1) },
    rim: { value: new Vector4() },
  };

  private readonly puffUniforms = {
    lobeTable: { value: null as Texture | null },
    fillet: { value: 1 },
    blend: { value: 0 },
    normalDepth: { value: null as Texture | null },
    colorCoverage: { value: null as Texture | null },
    pad: { value: 1 },
    distanceRange: { value: 1 },
  };

  /**
   * @param ramps holds those of the tints from 1 on, and says by its bands which one a body without a tint has
   * @param rows with one quad for each body; with two, front and back, where bodies are flat
   * @param surfaceDepth of the surfaces that bodies may touch; none where absent
   * @param isFlat whether bodies are as deep as their quads, for GPUs that do not keep a depth that fragments write
   */
  constructor(
    eye: FrameView,
    puffs: PuffTextures,
    ramps: RampTexture,
    rows: BufferGeometry,
    surfaceDepth?: SurfaceDepthPass,
    isFlat = false,
  ) {
    this.isFlat = isFlat;
    this.puffs = puffs;
    this.common = {
      ...eye.uniforms,
      ...this.ink.uniforms,
      ...(surfaceDepth?.uniforms ?? NO_SURFACES),
      ...this.uniforms,
      ramps: { value: ramps.texture },
      ...this.puffUniforms,
    };
    this.rows = new DrawnMesh(rows, this.lobesMaterial());
  }

  /**
   * Chooses how puffs become pixels, and follows other puffs; a form that is not drawn costs nothing.
   * @param billboards by what they are drawn; lobes are where absent, and where bodies are flat
   */
  setForm(billboards?: Shaders): void {
    this.rows.material = billboards && !this.isFlat ? this.billboardsMaterial(billboards) : this.lobesMaterial();
  }

  /**
   * Lets lines tremble, as when each drawing is traced anew.
   * @param boil 0..1: at 1 lines thin down to a half here and there
   * @param drawing number of the drawing; the same one looks the same again
   */
  setBoil(boil: number, drawing: number): void {
    this.uniforms.boil.value = boil;
    this.uniforms.drawing.value = drawing;
  }

  /**
   * @param innerLine depth gap, in puff radii, beyond which a puff is outlined against what lies behind it
   * @param innerTaper how much more gap, as a multiple, the line takes to reach its full width
   */
  setInk(line: InkLine, innerLine: number, innerTaper: number): void {
    this.ink.set(line);
    this.uniforms.innerLine.value = innerLine;
    this.uniforms.innerTaper.value = innerTaper;
  }

  /** @param width of the band along silhouettes that look away from the light, 0 (none) to 1 */
  setRim(color: Color, width: number): void {
    this.uniforms.rim.value.set(color[0] / 255, color[1] / 255, color[2] / 255, width);
  }

  /**
   * Fills from `color` at the low end of the gradient to the smoke's own colour at the high end.
   * @param bottom, top heights in the world, metres, between which the gradient 'height' runs
   */
  setGradient(gradient: Gradient, color: Color, smokeColor: Color, [bottom, top]: readonly [number, number]): void {
    const { gradientFactor, heights, gradientWeights } = this.uniforms;
    heights.value.set(bottom, Number(gradient === 'height') / Math.max(top - bottom, 1e-6));
    gradientWeights.value.set(Number(gradient === 'puff'), Number(gradient === 'screen'), Number(gradient === 'age'));
    gradientFactor.value.fromArray(
      color.map((channel, index) => (gradient === 'none' ? 1 : channel / Math.max(1, smokeColor[index]))),
    );
  }

  draw(renderer: WebGLRenderer): void {
    this.rows.draw(renderer);
  }

  /** What it draws with at present. */
  get material(): RawShaderMaterial {
    return this.rows.material;
  }

  /** Draws once in another material, made of the present one. */
  drawAs(renderer: WebGLRenderer, material: RawShaderMaterial): void {
    this.rows.drawAs(renderer, material);
  }

  dispose(): void {
    for (const material of this.materials.values()) material.dispose();
  }

  private lobesMaterial(): RawShaderMaterial {
    const { lobeTable, puffs } = this.puffs.lobes;
    const { lobeCount } = puffs;
    this.puffUniforms.lobeTable.value = lobeTable;
    this.puffUniforms.fillet.value = puffs.fillet;
    this.puffUniforms.blend.value = puffs.blend;
    return this.materialOf(lobeCount, lobeBodyShaders(lobeCount, this.isFlat));
  }

  private billboardsMaterial(shaders: Shaders): RawShaderMaterial {
    const { layers, normalDepth, colorCoverage } = this.puffs.billboards;
    this.puffUniforms.normalDepth.value = normalDepth;
    this.puffUniforms.colorCoverage.value = colorCoverage;
    this.puffUniforms.pad.value = layers.pad;
    this.puffUniforms.distanceRange.value = layers.distanceRange;
    return this.materialOf(0, { ...shaders, defines: definesOf(this.isFlat) });
  }

  private materialOf(lobes: number, shaders: Shaders): RawShaderMaterial {
    const { common, isFlat } = this;
    const made = () =>
      new RawShaderMaterial({
        ...shaders,
        glslVersion: GLSL3,
        uniforms: common,
        ...(isFlat ? { side: DoubleSide } : {}),
      });
    const material = this.materials.get(lobes) ?? made();
    this.materials.set(lobes, material);
    return material;
  }
}

/** By which puffs of so many lobes are drawn. */
export function lobeBodyShaders(lobes: number, isFlat: boolean): Shaders {
  return {
    vertexShader: withLobes(lobesVertexShader, lobes),
    fragmentShader: withLobes(lobesFragmentShader, lobes),
    defines: definesOf(isFlat),
  };
}

function definesOf(isFlat: boolean): Shaders['defines'] {
  return isFlat ? { FLAT: '' } : {};
}
