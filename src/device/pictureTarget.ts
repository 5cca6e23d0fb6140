import { NearestFilter, NoColorSpace, WebGLRenderTarget } from 'three';

/** A target for one display-encoded colour that is read pixel by pixel; 1 x 1 until it is given a size. */
export function pictureTarget(): WebGLRenderTarget {
  return new WebGLRenderTarget(1, 1, {
    colorSpace: NoColorSpace,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    generateMipmaps: false,
    depthBuffer: false,
  });
}
