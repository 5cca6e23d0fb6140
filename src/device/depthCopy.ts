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

/** A target whose depth, of 24 bits beside a stencil, is a texture, for a copy of a depth that is being drawn into. */
export function depthCopy(): WebGLRenderTarget {
  const depthTexture = new DepthTexture(1, 1, UnsignedInt248Type);
  depthTexture.format = DepthStencilFormat;
  // The colour is there because a target must have one; it is never drawn.
  return new WebGLRenderTarget(1, 1, {
    format: RedFormat,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    stencilBuffer: true,
    depthTexture,
  });
}

/**
 * Copies a rectangle of the depth that is being drawn into, for which three.js has no call when it is the canvas, and
 * leaves the copy bound. Of a depth with samples only what stays in its place can be copied.
 * @param from, to, size in pixels
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

/** Which depths a context can copy: those of the same kind. Asking the GPU takes time, so each is looked at once. */
export class CopyableDepths {
  private readonly known = new WeakMap<object, boolean>();

  /** Whether the depth that is being drawn into is one of them. */
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
