import { Color as ThreeColor, type WebGLRenderer } from 'three';
import fragmentShader from '../../shaders/backdrop/backdrop.frag';
import type { FrameView } from '../device/frameView.ts';
import { FullScreen } from '../device/fullScreen.ts';
import { writeColor, type Color } from '../device/ramps.ts';

/** Draws the background gradient. Reads no textures; writes the lit and the unlit colour. */
export class BackdropPass {
  private readonly uniforms = { topColor: { value: new ThreeColor() }, bottomColor: { value: new ThreeColor() } };
  private readonly triangle: FullScreen;

  constructor(eye: FrameView) {
    this.triangle = new FullScreen(fragmentShader, { ...eye.uniforms, ...this.uniforms });
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
