import type { DepthTexture, WebGLRenderer } from 'three';
import type { Targets } from './targets.ts';

/** A copy of the depth of the surfaces. */
export interface SurfaceDepth {
  readonly depth: DepthTexture;
  /** Extent of its depth test about a pixel's centre, pixels. */
  readonly slack: number;
}

/** Copies the depth of the surfaces for puffs that touch them. See shaders/lib/contact.glsl. */
export class SurfaceDepthPass {
  private readonly hasSurfaces: boolean;

  /** @param hasSurfaces whether there are surfaces to touch; if not, nothing is copied or allocated */
  constructor(hasSurfaces: boolean) {
    this.hasSurfaces = hasSurfaces;
  }

  /** Copies the depth if lines are drawn, and leaves the targets bound. */
  copy(renderer: WebGLRenderer, targets: Targets, isInked: boolean): SurfaceDepth | undefined {
    return isInked && this.hasSurfaces ? { depth: targets.copyDepth(renderer), slack: 0 } : undefined;
  }
}
