import { Color as ThreeColor, GLSL3, RawShaderMaterial, type WebGLRenderer } from 'three';
import fragmentShader from '../../shaders/backdrop/backdrop.frag';
import vertexShader from '../../shaders/lib/fullScreen.vert';
import type { Eye } from '../device/eye.ts';
import { FullScreen } from '../device/fullScreen.ts';
import { writeColor, type Color } from '../device/ramps.ts';

/** Paints what lies behind everything, if anything does. Reads nothing; writes both colours. */
export class BackdropPass {
  private readonly uniforms = { topColor: { value: new ThreeColor() }, bottomColor: { value: new ThreeColor() } };
  private readonly triangle: FullScreen;

  constructor(eye: Eye) {
    const material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader,
      uniforms: { ...this.uniforms, viewport: eye.uniforms.viewport },
      depthTest: false,
      depthWrite: false,
    });
    this.triangle = new FullScreen(material);
  }

  setColors(top: Color, bottom: Color): void {
    writeColor(top, this.uniforms.topColor);
    writeColor(bottom, this.uniforms.bottomColor);
  }

  draw(renderer: WebGLRenderer): void {
    this.triangle.draw(renderer);
  }

  dispose(): void {
    this.triangle.dispose();
  }
}
