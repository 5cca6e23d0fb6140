import { Vector2, type DepthTexture, type IUniform, type WebGLRenderer } from 'three';
import { CopyableDepths, copyDepth, depthCopy } from '../device/depthCopy.ts';
import type { Targets } from './targets.ts';

/**
 * Extent of the depth test about a pixel's centre in a multisampled framebuffer, pixels: samples are spread over the
 * pixel.
 */
const SLACK_OF_SAMPLES = 0.75;

/**
 * Copies the depth of the surfaces for puffs that touch them, because a depth buffer that is bound for drawing cannot
 * be sampled. See shaders/lib/contact.glsl.
 */
export class SurfaceDepthPass {
  readonly uniforms: {
    surfaceDepth: IUniform<DepthTexture>;
    hasSurfaces: IUniform<boolean>;
    surfaceSlack: IUniform<number>;
  };
  /** The host's depth in the viewport of the smoke. */
  private readonly copy = depthCopy();
  /** The host's whole depth buffer, if smoke is drawn into a part of it. */
  private readonly whole = depthCopy();
  private readonly copyable = new CopyableDepths();
  private readonly hasSurfaces: boolean;

  /** @param hasSurfaces whether there are surfaces to touch; if not, nothing is copied or allocated */
  constructor(hasSurfaces: boolean) {
    this.hasSurfaces = hasSurfaces;
    this.uniforms = {
      surfaceDepth: { value: this.copy.depthTexture! },
      hasSurfaces: { value: false },
      surfaceSlack: { value: 0 },
    };
  }

  /** Copies the depth if lines are drawn, and leaves the targets bound. */
  draw(renderer: WebGLRenderer, targets: Targets, isInked: boolean): void {
    this.uniforms.hasSurfaces.value = isInked && this.hasSurfaces;
    if (!this.uniforms.hasSurfaces.value) return;
    this.uniforms.surfaceDepth.value = targets.copyDepth(renderer);
  }

  /**
   * Copies the depth of the host's bound framebuffer and unbinds that framebuffer. If the depth format cannot be
   * copied, smoke has no contact lines.
   * @param origin lower left corner of the viewport of the smoke, pixels
   * @param size size of that viewport, pixels
   */
  takeFromHost(renderer: WebGLRenderer, origin: Vector2, size: Vector2, isInked: boolean): void {
    const gl = renderer.getContext() as WebGL2RenderingContext;
    const { surfaceSlack, hasSurfaces } = this.uniforms;
    hasSurfaces.value = isInked && this.copyable.includesBound(gl);
    if (!hasSurfaces.value) return;
    surfaceSlack.value = (gl.getParameter(gl.SAMPLES) as number) > 0 ? SLACK_OF_SAMPLES : 0;
    const isPart = origin.x > 0 || origin.y > 0;
    copyDepth(renderer, isPart ? this.whole : this.copy, origin, origin, size);
    if (isPart) copyDepth(renderer, this.copy, origin, new Vector2(), size);
    this.uniforms.surfaceDepth.value = this.copy.depthTexture!;
  }

  dispose(): void {
    this.copy.dispose();
    this.whole.dispose();
  }
}
