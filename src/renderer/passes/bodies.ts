import {
  DoubleSide,
  GLSL3,
  RawShaderMaterial,
  Vector2,
  Vector3,
  type IUniform,
  type Texture,
  type WebGLRenderer,
} from 'three';
import lobesFragmentShader from '../../../shaders/bodies/lobes.frag';
import lobesVertexShader from '../../../shaders/bodies/lobes.vert';
import { DrawnRows, type RowGeometry } from '../gpu/drawnRows.ts';
import type { FrameView } from '../gpu/frameView.ts';
import { DEFORMED, withLobes, type Shaders } from '../gpu/programsAhead.ts';
import type { PuffTextures } from '../gpu/puffTextures.ts';
import type { RampTexture } from '../gpu/ramps.ts';
import type { SurfaceDepth } from './surfaceDepth.ts';

/** The coordinate that a gradient fill follows. */
export type Gradient = 'none' | 'puff' | 'height' | 'screen' | 'age';

/** What changes the code of bodies. */
export interface BodyKind {
  /** Whether puffs have the depth of their quads, for GPUs that do not keep the depth that fragments write. */
  isFlat: boolean;
  /** Whether puffs also write the shading of `Targets`. */
  isShaded: boolean;
  /** Whether lobe puffs turn or stretch with the air, or unfold. */
  isDeformed: boolean;
  /** Whether planes cut off puffs. A loop over them costs a fifth of a body, also without planes. */
  isClipped?: boolean;
}

/** Draws the puffs: lit and unlit colour, ink, and depth. Puffs are opaque, so rows can be in any order. */
export class BodiesPass {
  private readonly rows: DrawnRows;
  /**
   * Materials by lobe count and by what else changes their code, because the shaders unroll the loop over the lobes.
   * Billboards count as 0 lobes.
   */
  private readonly materials = new Map<string, RawShaderMaterial>();
  private readonly puffs: PuffTextures;
  private readonly isFlat: boolean;
  private readonly eye: FrameView;
  private billboards: Shaders | undefined;
  private isShaded = false;
  private isClipped = false;
  private readonly common: Record<string, IUniform>;
  private readonly uniforms = {
    surfaceDepth: { value: null as Texture | null },
    hasSurfaces: { value: false },
    surfaceSlack: { value: 0 },
    drawing: { value: 0 },
    heights: { value: new Vector2() },
    gradientWeights: { value: new Vector3() },
  };

  private readonly puffUniforms = {
    lobeTable: { value: null as Texture | null },
    fillet: { value: 1 },
    blend: { value: 0 },
  };

  /**
   * @param ramps ramps 1 and up are those of the tints; its bands select the ramp of a puff without a tint
   * @param isFlat whether puffs have the depth of their quads, for GPUs that do not keep the depth that fragments write
   */
  constructor(eye: FrameView, puffs: PuffTextures, ramps: RampTexture, isFlat = false) {
    this.isFlat = isFlat;
    this.eye = eye;
    this.puffs = puffs;
    this.common = {
      ...eye.uniforms,
      ...this.uniforms,
      ramps: { value: ramps.texture },
      ...this.puffUniforms,
    };
    this.rows = new DrawnRows(this.lobesMaterial());
  }

  /**
   * Selects the shaders of a puff form and binds the current puffs. A form that is not drawn is not uploaded.
   * @param billboards shaders of the billboards; without them, or if the puffs are flat, lobes are drawn
   */
  setForm(billboards?: Shaders): void {
    this.billboards = this.isFlat ? undefined : billboards;
    this.rows.bites = this.puffs.bites?.bodies;
    this.selectMaterial();
  }

  /** Index of the drawing, for the boil of lines; equal indices give equal lines. */
  get drawing(): number {
    return this.uniforms.drawing.value;
  }

  setDrawing(drawing: number): void {
    this.uniforms.drawing.value = drawing;
  }

  /** @param bottom, top world heights, metres, between which the gradient 'height' runs */
  setGradient(gradient: Gradient, [bottom, top]: readonly [number, number]): void {
    const { heights, gradientWeights } = this.uniforms;
    heights.value.set(bottom, Number(gradient === 'height') / Math.max(top - bottom, 1e-6));
    gradientWeights.value.set(Number(gradient === 'puff'), Number(gradient === 'screen'), Number(gradient === 'age'));
  }

  /**
   * @param rows one quad for each row, or two (front and back) if the puffs are flat
   * @param surfaces depth of the surfaces that puffs may touch; without it puffs have no contact lines
   * @param isShaded whether puffs also write the shading of `Targets`, and their gradient in place of their colours
   */
  draw(renderer: WebGLRenderer, rows: RowGeometry, surfaces?: SurfaceDepth, isShaded = false): void {
    if (this.isShaded !== isShaded) {
      this.isShaded = isShaded;
      this.selectMaterial();
    }
    this.touch(surfaces);
    this.rows.draw(renderer, rows);
  }

  /** The material of the draw call. */
  get material(): RawShaderMaterial {
    return this.rows.material;
  }

  /** Draws once with a variant of the material. */
  drawAs(renderer: WebGLRenderer, material: RawShaderMaterial, rows: RowGeometry, surfaces?: SurfaceDepth): void {
    this.touch(surfaces);
    this.rows.drawAs(renderer, material, rows);
  }

  dispose(): void {
    for (const material of this.materials.values()) material.dispose();
  }

  private touch(surfaces: SurfaceDepth | undefined): void {
    if (this.isClipped !== this.eye.uniforms.planeCount.value > 0) this.selectMaterial();
    this.uniforms.hasSurfaces.value = surfaces !== undefined;
    this.uniforms.surfaceDepth.value = surfaces?.depth ?? null;
    this.uniforms.surfaceSlack.value = surfaces?.slack ?? 0;
  }

  private selectMaterial(): void {
    const { eye, billboards } = this;
    this.isClipped = eye.uniforms.planeCount.value > 0;
    this.rows.material = eye.variantOf(billboards ? this.billboardsMaterial(billboards) : this.lobesMaterial());
  }

  private lobesMaterial(): RawShaderMaterial {
    const { lobeTable, puffs } = this.puffs.lobes;
    const { lobeCount } = puffs;
    this.puffUniforms.lobeTable.value = lobeTable;
    this.puffUniforms.fillet.value = puffs.fillet;
    this.puffUniforms.blend.value = puffs.blend;
    return this.materialOf(lobeCount, lobeBodyShaders(lobeCount, this.kind));
  }

  private billboardsMaterial(shaders: Shaders): RawShaderMaterial {
    Object.assign(this.common, this.puffs.billboards.uniforms);
    return this.materialOf(0, { ...shaders, defines: definesOf(this.kind) });
  }

  private get kind(): BodyKind {
    const { isFlat, isShaded, isClipped, puffs } = this;
    return { isFlat, isShaded, isClipped, isDeformed: puffs.isDeformed };
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
    const key = [lobes, ...Object.keys(shaders.defines ?? {})].join(' ');
    const material = this.materials.get(key) ?? made();
    this.materials.set(key, material);
    return material;
  }
}

/** The shaders of puffs with a number of lobes, with their loops unrolled. */
export function lobeBodyShaders(lobes: number, kind: BodyKind): Shaders {
  return {
    vertexShader: withLobes(lobesVertexShader, lobes),
    fragmentShader: withLobes(lobesFragmentShader, lobes),
    defines: definesOf(kind),
  };
}

function definesOf({ isFlat, isShaded, isDeformed, isClipped }: BodyKind): Shaders['defines'] {
  return {
    ...(isFlat && { FLAT: '' }),
    ...(isShaded && { SHADING: '' }),
    ...(isDeformed && DEFORMED),
    ...(isClipped && { CLIPPED: '' }),
  };
}
