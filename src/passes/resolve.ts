import { Color as ThreeColor, type Texture, type WebGLRenderer, type WebGLRenderTarget } from 'three';
import fragmentShader from '../../shaders/resolve/resolve.frag';
import { FullScreen } from '../device/fullScreen.ts';
import { writeColor, type Color } from '../device/ramps.ts';
import type { Targets } from './targets.ts';

/** Chooses lit or unlit by the mask, smooths edges and writes premultiplied colour to the canvas or to a target. */
export class ResolvePass {
  private readonly uniforms = {
    unlit: { value: null as Texture | null },
    lit: { value: null as Texture | null },
    deepShadow: { value: new ThreeColor() },
    smoothEdges: { value: true },
    isAllDeep: { value: false },
  };
  private readonly triangle = new FullScreen(fragmentShader, this.uniforms);

  /** @param color what the colour of shadow is multiplied by where shadow is deep */
  setDeepShadow(color: Color): void {
    writeColor(color, this.uniforms.deepShadow);
  }

  set smoothEdges(smooth: boolean) {
    this.uniforms.smoothEdges.value = smooth;
  }

  /** Draws as if all of it were in deep shadow. @param output as below */
  drawDeep(renderer: WebGLRenderer, targets: Pick<Targets, 'unlit' | 'lit'>, output: WebGLRenderTarget | null): void {
    this.uniforms.isAllDeep.value = true;
    this.draw(renderer, targets, output);
    this.uniforms.isAllDeep.value = false;
  }

  /** @param output the target to write, or null for the canvas */
  draw(renderer: WebGLRenderer, targets: Pick<Targets, 'unlit' | 'lit'>, output: WebGLRenderTarget | null): void {
    this.uniforms.unlit.value = targets.unlit;
    this.uniforms.lit.value = targets.lit;
    renderer.setRenderTarget(output);
    this.triangle.draw(renderer);
  }

  dispose(): void {
    this.triangle.dispose();
  }
}
