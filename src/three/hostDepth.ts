import { Vector2, type DepthTexture, type WebGLRenderer, type WebGLRenderTarget } from 'three';
import { depthCopy } from '../renderer/gpu/depthCopy.ts';
import type { SurfaceDepth } from '../renderer/passes/surfaceDepth.ts';

/**
 * Extent of the depth test about a pixel's centre in a multisampled framebuffer, pixels: samples are spread over the
 * pixel.
 */
const SLACK_OF_SAMPLES = 0.75;

/** A copy of the depth in the viewport of the smoke. */
export interface CopiedDepth extends SurfaceDepth {
  /** The same depth at the coordinates of the framebuffer. */
  readonly inPlace: DepthTexture;
}

/** Copies the depth of the host's framebuffer, for puffs that touch the host's scene and for shadow on it. */
export class HostDepth {
  /** The depth in the viewport of the smoke. */
  private readonly copy = depthCopy();
  /** The whole depth buffer, if smoke is drawn into a part of it. */
  private readonly whole = depthCopy();
  private readonly copyable = new CopyableDepths();

  /**
   * Copies the depth of the host's bound framebuffer and unbinds that framebuffer. If the depth format cannot be
   * copied, smoke has no contact lines, and shadow volumes are counted.
   * @param origin lower left corner of the viewport of the smoke, pixels
   * @param size size of that viewport, pixels
   */
  copyDepth(renderer: WebGLRenderer, origin: Vector2, size: Vector2, isNeeded: boolean): CopiedDepth | undefined {
    const gl = renderer.getContext() as WebGL2RenderingContext;
    if (!isNeeded || !this.copyable.includesBound(gl)) return undefined;
    const slack = (gl.getParameter(gl.SAMPLES) as number) > 0 ? SLACK_OF_SAMPLES : 0;
    const isPart = origin.x > 0 || origin.y > 0;
    copyDepth(renderer, isPart ? this.whole : this.copy, origin, origin, size);
    if (isPart) copyDepth(renderer, this.copy, origin, new Vector2(), size);
    return { depth: this.copy.depthTexture!, slack, inPlace: (isPart ? this.whole : this.copy).depthTexture! };
  }

  /** Frees the GPU resources. The next copy recreates them. */
  dispose(): void {
    this.copy.dispose();
    this.whole.dispose();
  }
}

/**
 * Copies a rectangle of the bound framebuffer's depth, and leaves the copy bound. three.js cannot copy the depth of the
 * canvas. The depth of a multisampled framebuffer can only be copied to the same coordinates.
 * @param from lower left corner in the source, pixels
 * @param to lower left corner in the copy, pixels
 * @param size size of the rectangle, pixels
 */
function copyDepth(renderer: WebGLRenderer, copy: WebGLRenderTarget, from: Vector2, to: Vector2, size: Vector2) {
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const source = gl.getParameter(gl.DRAW_FRAMEBUFFER_BINDING) as WebGLFramebuffer | null;
  const [fromEnd, toEnd] = [from.clone().add(size), to.clone().add(size)];
  copy.setSize(toEnd.x, toEnd.y);
  renderer.setRenderTarget(copy);
  gl.bindFramebuffer(gl.READ_FRAMEBUFFER, source);
  gl.blitFramebuffer(
    from.x,
    from.y,
    fromEnd.x,
    fromEnd.y,
    to.x,
    to.y,
    toEnd.x,
    toEnd.y,
    gl.DEPTH_BUFFER_BIT,
    gl.NEAREST,
  );
  gl.bindFramebuffer(gl.READ_FRAMEBUFFER, gl.getParameter(gl.DRAW_FRAMEBUFFER_BINDING) as WebGLFramebuffer);
}

/**
 * Tests whether a depth buffer has the format of the copy, which a blit requires. Results are memoized by framebuffer,
 * because the query is slow.
 */
class CopyableDepths {
  private readonly known = new WeakMap<object, boolean>();

  /** Whether the depth of the bound framebuffer can be copied. */
  includesBound(gl: WebGL2RenderingContext): boolean {
    const framebuffer = gl.getParameter(gl.DRAW_FRAMEBUFFER_BINDING) as WebGLFramebuffer | null;
    const key = framebuffer ?? gl;
    const isCopyable = this.known.get(key) ?? isLikeTheCopy(gl, framebuffer ? gl.DEPTH_ATTACHMENT : gl.DEPTH);
    this.known.set(key, isCopyable);
    return isCopyable;
  }
}

function isLikeTheCopy(gl: WebGL2RenderingContext, attachment: number): boolean {
  const ask = (name: number) => gl.getFramebufferAttachmentParameter(gl.DRAW_FRAMEBUFFER, attachment, name) as number;
  return (
    ask(gl.FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE) === 24 &&
    ask(gl.FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) === gl.UNSIGNED_NORMALIZED
  );
}
