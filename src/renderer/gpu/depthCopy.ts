import {
  DepthStencilFormat,
  DepthTexture,
  NearestFilter,
  RedFormat,
  UnsignedInt248Type,
  WebGLRenderTarget,
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
