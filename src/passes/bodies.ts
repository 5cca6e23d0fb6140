import {
  Camera,
  GLSL3,
  Mesh,
  RawShaderMaterial,
  Scene,
  Vector2,
  Vector3,
  Vector4,
  type BufferGeometry,
  type IUniform,
  type WebGLRenderer,
} from 'three';
import billboardsFragmentShader from '../../shaders/bodies/billboards.frag';
import billboardsVertexShader from '../../shaders/bodies/billboards.vert';
import lobesFragmentShader from '../../shaders/bodies/lobes.frag';
import lobesVertexShader from '../../shaders/bodies/lobes.vert';
import type { Eye } from '../device/eye.ts';
import type { PuffForm, PuffTextures } from '../device/puffTextures.ts';
import type { Color, RampTexture } from '../device/ramps.ts';
import { InkUniforms, type InkLine } from './ink.ts';

/** What runs along a gradient fill. */
export type Gradient = 'none' | 'puff' | 'height' | 'screen' | 'age';

const GRADIENTS: readonly Gradient[] = ['puff', 'height', 'screen', 'age'];

/** Draws the bodies: colour in light and in shadow, ink, and depth. Opaque and free of any order. */
export class BodiesPass {
  private readonly scene = new Scene();
  private readonly camera = new Camera();
  private readonly mesh: Mesh<BufferGeometry, RawShaderMaterial>;
  private readonly materials: Partial<Record<PuffForm, RawShaderMaterial>> = {};
  private readonly puffs: PuffTextures;
  private readonly common: Record<string, IUniform>;
  private readonly ink = new InkUniforms();
  private readonly uniforms = {
    innerLine: { value: 0.5 },
    plumeHeight: { value: new Vector2(0, 1) },
    gradientWeights: { value: new Vector4() },
    gradientFactor: { value: new Vector3(1, 1, 1) },
  };

  /** @param material which ramp of `ramps` is the smoke's; those of its tints follow it */
  constructor(eye: Eye, puffs: PuffTextures, ramps: RampTexture, material: number, rows: BufferGeometry) {
    const { litRow, unlitRow } = ramps.rows(material);
    this.puffs = puffs;
    this.common = {
      ...eye.uniforms,
      ...this.ink.uniforms,
      ...this.uniforms,
      ramps: { value: ramps.texture },
      litRow: { value: litRow },
      unlitRow: { value: unlitRow },
      rampPitch: { value: ramps.pitch },
    };
    this.mesh = new Mesh(rows, this.materialOf('lobes'));
    this.mesh.frustumCulled = false;
    this.scene.add(this.mesh);
  }

  /** Chooses how puffs become pixels; a form that is not drawn costs nothing. */
  setForm(form: PuffForm): void {
    this.mesh.material = this.materialOf(form);
  }

  /** @param innerLine depth gap, in puff radii, beyond which a puff is outlined against what lies behind it */
  setInk(line: InkLine, innerLine: number): void {
    this.ink.set(line);
    this.uniforms.innerLine.value = innerLine;
  }

  /** Fills from `color` at the low end of the gradient to the smoke's own colour at the high end. */
  setGradient(gradient: Gradient, color: Color, smokeColor: Color): void {
    const { gradientFactor, gradientWeights } = this.uniforms;
    gradientWeights.value.fromArray(GRADIENTS.map((name) => (name === gradient ? 1 : 0)));
    const factor = color.map((channel, index) => channel / Math.max(1, smokeColor[index]));
    gradientFactor.value.fromArray(gradient === 'none' ? [1, 1, 1] : factor);
  }

  /** World heights between which the gradient 'height' runs. */
  setPlumeHeight(bottom: number, top: number): void {
    this.uniforms.plumeHeight.value.set(bottom, top);
  }

  draw(renderer: WebGLRenderer): void {
    renderer.render(this.scene, this.camera);
  }

  dispose(): void {
    for (const material of Object.values(this.materials)) material.dispose();
  }

  private materialOf(form: PuffForm): RawShaderMaterial {
    this.materials[form] ??= form === 'lobes' ? this.lobesMaterial() : this.billboardsMaterial();
    return this.materials[form];
  }

  private lobesMaterial(): RawShaderMaterial {
    const { lobeTable, puffs } = this.puffs.lobes;
    return new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: withLobes(lobesVertexShader, puffs.lobeCount),
      fragmentShader: withLobes(lobesFragmentShader, puffs.lobeCount),
      uniforms: {
        ...this.common,
        lobeTable: { value: lobeTable },
        fillet: { value: puffs.fillet },
        blend: { value: puffs.blend },
      },
    });
  }

  private billboardsMaterial(): RawShaderMaterial {
    const { layers, normalDepth, colorCoverage } = this.puffs.billboards;
    return new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: billboardsVertexShader,
      fragmentShader: billboardsFragmentShader,
      uniforms: {
        ...this.common,
        normalDepth: { value: normalDepth },
        colorCoverage: { value: colorCoverage },
        pad: { value: layers.pad },
        distanceRange: { value: layers.distanceRange },
      },
    });
  }
}

/** Puts the number in as digits, which three.js needs to unroll the loops, and then the shader has no dynamic index. */
function withLobes(shader: string, lobes: number): string {
  return shader.replaceAll(/\bLOBES\b/g, String(lobes));
}
