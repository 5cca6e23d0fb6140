import {
  DepthStencilFormat,
  DepthTexture,
  NearestFilter,
  RedFormat,
  UnsignedInt248Type,
  WebGLRenderTarget,
  type IUniform,
  type WebGLRenderer,
} from 'three';
import type { Targets } from './targets.ts';

/**
 * Keeps a copy of the depth that the surfaces leave, for bodies that touch them: what is drawn into cannot be read.
 * See shaders/lib/contact.glsl.
 */
export class SurfaceDepthPass {
  readonly uniforms: { surfaceDepth: IUniform<DepthTexture>; hasSurfaces: IUniform<boolean> };
  private readonly copy: WebGLRenderTarget;
  private readonly hasSurfaces: boolean;

  /** @param hasSurfaces whether there is anything to touch; without it nothing is copied and no memory is taken */
  constructor(hasSurfaces: boolean) {
    const depthTexture = new DepthTexture(1, 1, UnsignedInt248Type);
    depthTexture.format = DepthStencilFormat;
    // The colour is there because a target must have one; it is never drawn.
    this.copy = new WebGLRenderTarget(1, 1, {
      format: RedFormat,
      minFilter: NearestFilter,
      magFilter: NearestFilter,
      stencilBuffer: true,
      depthTexture,
    });
    this.hasSurfaces = hasSurfaces;
    this.uniforms = { surfaceDepth: { value: depthTexture }, hasSurfaces: { value: false } };
  }

  /** Copies the depth, if lines are drawn at all, and goes on drawing into the targets. */
  draw(renderer: WebGLRenderer, targets: Targets, isInked: boolean): void {
    this.uniforms.hasSurfaces.value = isInked && this.hasSurfaces;
    if (!this.uniforms.hasSurfaces.value) return;
    this.copy.setSize(targets.width, targets.height);
    renderer.initRenderTarget(this.copy);
    renderer.copyTextureToTexture(targets.depth, this.copy.depthTexture!);
    renderer.setRenderTarget(targets.renderTarget);
  }

  dispose(): void {
    this.copy.dispose();
  }
}
