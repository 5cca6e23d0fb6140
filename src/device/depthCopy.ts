import {
  DepthStencilFormat,
  DepthTexture,
  NearestFilter,
  RedFormat,
  UnsignedInt248Type,
  WebGLRenderTarget,
  type Vector2,
  type WebGLRenderer,
} from 'three';

/** A render target with a 24-bit depth and stencil texture, the destination for copies of a depth buffer in use. */
export function depthCopy(): WebGLRenderTarget {
  const depthTexture = new DepthTexture(1, 1, UnsignedInt248Type);
  depthTexture.format = DepthStencilFormat;
  // A render target needs a colour attachment; this one is never written.
  return new WebGLRenderTarget(1, 1, {
    format: RedFormat,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    stencilBuffer: true,
    depthTexture,
  });
}

/**
 * Copies a rectangle of the bound framebuffer's depth, and leaves the copy bound. three.js cannot copy the depth of the
 * canvas. The depth of a multisampled framebuffer can only be copied to the same coordinates.
 * @param from lower left corner in the source, pixels
 * @param to lower left corner in the copy, pixels
 * @param size size of the rectangle, pixels
 */
export function copyDepth(renderer: WebGLRenderer, copy: WebGLRenderTarget, from: Vector2, to: Vector2, size: Vector2) {
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
export class CopyableDepths {
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
