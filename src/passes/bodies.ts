import {
  Camera,
  Color as ThreeColor,
  GLSL3,
  Mesh,
  RawShaderMaterial,
  Scene,
  Vector2,
  Vector3,
  Vector4,
  type BufferGeometry,
  type WebGLRenderer,
} from 'three';
import fragmentShader from '../../shaders/bodies/bodies.frag';
import vertexShader from '../../shaders/bodies/bodies.vert';
import type { Eye } from '../device/eye.ts';
import type { PuffTextures } from '../device/puffTextures.ts';
import { writeColor, type Color, type RampTexture } from '../device/ramps.ts';

/** What runs along a gradient fill. */
export type Gradient = 'none' | 'puff' | 'height' | 'screen' | 'age';

const GRADIENTS: readonly Gradient[] = ['puff', 'height', 'screen', 'age'];

/** Draws the bodies: colour in light and in shadow, ink, and depth. Opaque and free of any order. */
export class BodiesPass {
  private readonly scene = new Scene();
  private readonly camera = new Camera();
  private readonly material: RawShaderMaterial;
  private readonly uniforms = {
    inkColor: { value: new ThreeColor() },
    inkPixels: { value: 2 },
    innerLine: { value: 0.5 },
    plumeHeight: { value: new Vector2(0, 1) },
    gradientWeights: { value: new Vector4() },
    gradientFactor: { value: new Vector3(1, 1, 1) },
  };

  /** @param material which ramp of `ramps` is the smoke's; those of its tints follow it */
  constructor(eye: Eye, puffs: PuffTextures, ramps: RampTexture, material: number, rows: BufferGeometry) {
    const { litRow, unlitRow } = ramps.rows(material);
    this.material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader,
      uniforms: {
        ...eye.uniforms,
        ...this.uniforms,
        normalDepth: { value: puffs.normalDepth },
        colorCoverage: { value: puffs.colorCoverage },
        pad: { value: puffs.layers.pad },
        distanceRange: { value: puffs.layers.distanceRange },
        ramps: { value: ramps.texture },
        litRow: { value: litRow },
        unlitRow: { value: unlitRow },
        rampPitch: { value: ramps.pitch },
      },
    });
    const mesh = new Mesh(rows, this.material);
    mesh.frustumCulled = false;
    this.scene.add(mesh);
  }

  /**
   * @param pixels width of the line in pixels of the target; 0 draws none
   * @param innerLine depth gap, in puff radii, beyond which a puff is outlined against what lies behind it
   */
  setInk(color: Color, pixels: number, innerLine: number): void {
    writeColor(color, this.uniforms.inkColor);
    this.uniforms.inkPixels.value = pixels;
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
    this.material.dispose();
  }
}
