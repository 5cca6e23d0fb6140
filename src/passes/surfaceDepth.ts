import { Vector2, type DepthTexture, type WebGLRenderer } from 'three';
import { CopyableDepths, copyDepth, depthCopy } from '../device/depthCopy.ts';
import type { Targets } from './targets.ts';

/**
 * Extent of the depth test about a pixel's centre in a multisampled framebuffer, pixels: samples are spread over the
 * pixel.
 */
const SLACK_OF_SAMPLES = 0.75;

/** A copy of the depth of the surfaces. */
export interface SurfaceDepth {
  readonly depth: DepthTexture;
  /** Extent of its depth test about a pixel's centre, pixels. */
  readonly slack: number;
}

/** Copies the depth of the surfaces for puffs that touch them. See shaders/lib/contact.glsl. */
export class SurfaceDepthPass {
  /** The host's depth in the viewport of the smoke. */
  private readonly copy = depthCopy();
  /** The host's whole depth buffer, if smoke is drawn into a part of it. */
  private readonly whole = depthCopy();
  private readonly copyable = new CopyableDepths();
  private readonly hasSurfaces: boolean;
  private readonly taken: { depth: DepthTexture; slack: number };

  /** @param hasSurfaces whether there are surfaces to touch; if not, nothing is copied or allocated */
  constructor(hasSurfaces: boolean) {
    this.hasSurfaces = hasSurfaces;
    this.taken = { depth: this.copy.depthTexture!, slack: 0 };
  }

  /** Copies the depth if lines are drawn, and leaves the targets bound. */
  take(renderer: WebGLRenderer, targets: Targets, isInked: boolean): SurfaceDepth | undefined {
    if (!isInked || !this.hasSurfaces) return undefined;
    this.taken.depth = targets.copyDepth(renderer);
    return this.taken;
  }

  /**
   * Copies the depth of the host's bound framebuffer and unbinds that framebuffer. If the depth format cannot be
   * copied, smoke has no contact lines.
   * @param origin lower left corner of the viewport of the smoke, pixels
   * @param size size of that viewport, pixels
   */
  takeFromHost(renderer: WebGLRenderer, origin: Vector2, size: Vector2, isInked: boolean): SurfaceDepth | undefined {
    const gl = renderer.getContext() as WebGL2RenderingContext;
    if (!isInked || !this.copyable.includesBound(gl)) return undefined;
    this.taken.slack = (gl.getParameter(gl.SAMPLES) as number) > 0 ? SLACK_OF_SAMPLES : 0;
    const isPart = origin.x > 0 || origin.y > 0;
    copyDepth(renderer, isPart ? this.whole : this.copy, origin, origin, size);
    if (isPart) copyDepth(renderer, this.copy, origin, new Vector2(), size);
    this.taken.depth = this.copy.depthTexture!;
    return this.taken;
  }

  dispose(): void {
    this.copy.dispose();
    this.whole.dispose();
  }
}
