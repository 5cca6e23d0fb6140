import { NearestFilter, NoColorSpace, WebGLRenderTarget } from 'three';

/** A render target for one display-encoded colour that is read by texelFetch; 1 x 1 until it is resized. */
export function pictureTarget(): WebGLRenderTarget {
  return new WebGLRenderTarget(1, 1, {
    colorSpace: NoColorSpace,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    generateMipmaps: false,
    depthBuffer: false,
  });
}
