import type { WebGLRenderer } from 'three';
import fragmentShader from '../../../shaders/backdrop/backdrop.frag';
import type { FrameView } from '../gpu/frameView.ts';
import { FullScreen } from '../gpu/fullScreen.ts';
import type { Tone } from '../gpu/ramps.ts';
import { MAX_COLORS } from '../../parameters/ramp.ts';

/** Draws the background gradient. Reads no textures; writes the lit and the unlit colour. */
export class BackdropPass {
  private readonly uniforms = { stops: { value: new Float32Array(4 * MAX_COLORS) }, stopCount: { value: 0 } };
  private readonly triangle: FullScreen;

  constructor(eye: FrameView) {
    const defines = { STOPS: MAX_COLORS };
    this.triangle = new FullScreen(fragmentShader, { ...eye.uniforms, ...this.uniforms }, { defines });
  }

  /** @param stops colours from bottom to top, blended between their heights 0..1; at most MAX_COLORS */
  setColors(stops: readonly Tone[]): void {
    stops.forEach(({ from, color }, stop) =>
      this.uniforms.stops.value.set([...color.map((channel) => channel / 255), from], 4 * stop),
    );
    this.uniforms.stopCount.value = stops.length;
  }

  draw(renderer: WebGLRenderer): void {
    this.triangle.draw(renderer);
  }

  dispose(): void {
    this.triangle.dispose();
  }
}
