import { type Texture, type WebGLRenderer, type WebGLRenderTarget } from 'three';
import edgesShader from '../../shaders/resolve/edges.frag';
import tonesShader from '../../shaders/resolve/tones.frag';
import type { FrameView } from '../device/frameView.ts';
import { FullScreen } from '../device/fullScreen.ts';
import { pictureTarget } from '../device/pictureTarget.ts';
import type { Targets } from './targets.ts';

/** The colours to resolve, and their size in pixels. */
export type ResolveSources = Pick<Targets, 'unlit' | 'lit' | 'width' | 'height'>;

/**
 * Chooses lit or unlit by the mask, smooths edges, and writes premultiplied colour to the canvas or to a render target.
 * Edge smoothing is a second draw call, because it reads many neighbours of a pixel and each must be chosen only once.
 */
export class ResolvePass {
  smoothEdges = true;
  private readonly uniforms = {
    unlit: { value: null as Texture | null },
    lit: { value: null as Texture | null },
    isAllDeep: { value: false },
    isLast: { value: false },
  };
  private readonly chosen = pictureTarget();
  private readonly tones: FullScreen;
  private readonly edges: FullScreen;

  constructor(eye: FrameView) {
    this.tones = new FullScreen(tonesShader, { ...eye.uniforms, ...this.uniforms });
    this.edges = new FullScreen(edgesShader, { ...eye.uniforms, tones: { value: this.chosen.texture } });
  }

  /**
   * Resolves as if everything were in deep shadow.
   * @param output render target, or null for the canvas
   */
  drawDeep(renderer: WebGLRenderer, sources: ResolveSources, output: WebGLRenderTarget | null): void {
    this.uniforms.isAllDeep.value = true;
    this.draw(renderer, sources, output);
    this.uniforms.isAllDeep.value = false;
  }

  /** @param output render target, or null for the canvas */
  draw(renderer: WebGLRenderer, { unlit, lit, width, height }: ResolveSources, output: WebGLRenderTarget | null): void {
    this.uniforms.unlit.value = unlit;
    this.uniforms.lit.value = lit;
    this.uniforms.isLast.value = !this.smoothEdges;
    if (this.smoothEdges) {
      this.chosen.setSize(width, height);
      renderer.setRenderTarget(this.chosen);
      this.tones.draw(renderer);
    }
    renderer.setRenderTarget(output);
    (this.smoothEdges ? this.edges : this.tones).draw(renderer);
  }

  dispose(): void {
    for (const part of [this.tones, this.edges, this.chosen]) part.dispose();
  }
}
