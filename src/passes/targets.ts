import {
  DepthStencilFormat,
  DepthTexture,
  NearestFilter,
  NoColorSpace,
  UnsignedByteType,
  UnsignedInt248Type,
  WebGLRenderTarget,
  type Texture,
  type WebGLRenderer,
} from 'three';
import { depthCopy } from '../device/depthCopy.ts';

/**
 * The render target of the passes: two display-encoded colours with one depth and stencil buffer. Colour 0 is unlit (in
 * shadow) with the alpha of the page; colour 1 is lit with the shadow mask in alpha.
 */
export class Targets {
  private readonly target = new WebGLRenderTarget(1, 1, {
    count: 2,
    type: UnsignedByteType,
    colorSpace: NoColorSpace,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    generateMipmaps: false,
    depthBuffer: true,
    stencilBuffer: true,
    // A texture, so that other passes can read it or attach it.
    depthTexture: depthStencil(),
  });

  private readonly copy = depthCopy();

  /** The underlying render target, with colours, depth and stencil. */
  get renderTarget(): WebGLRenderTarget {
    return this.target;
  }

  get unlit(): Texture {
    return this.target.textures[0];
  }

  get lit(): Texture {
    return this.target.textures[1];
  }

  /** Depth and stencil texture. A pass that renders to the target must not sample it. */
  get depth(): DepthTexture {
    return this.target.depthTexture!;
  }

  get width(): number {
    return this.target.width;
  }

  get height(): number {
    return this.target.height;
  }

  /**
   * @param width pixels, at least 1
   * @param height pixels, at least 1
   */
  resize(width: number, height: number): void {
    this.target.setSize(width, height);
  }

  /** Binds the target and clears it: colours to transparent black, depth to far, stencil to zero. */
  begin(renderer: WebGLRenderer): void {
    renderer.setRenderTarget(this.target);
    renderer.setClearColor(0x000000, 0);
    renderer.clear(true, true, true);
  }

  /**
   * Copies the depth as it is now, because a depth buffer that is bound for drawing cannot be sampled. Leaves the target
   * bound. Valid until the next call.
   */
  copyDepth(renderer: WebGLRenderer): DepthTexture {
    const depth = this.copy.depthTexture!;
    this.copy.setSize(this.width, this.height);
    renderer.initRenderTarget(this.copy);
    renderer.copyTextureToTexture(this.depth, depth);
    renderer.setRenderTarget(this.target);
    return depth;
  }

  dispose(): void {
    this.target.dispose();
    this.copy.dispose();
  }
}

function depthStencil(): DepthTexture {
  const texture = new DepthTexture(1, 1, UnsignedInt248Type);
  texture.format = DepthStencilFormat;
  return texture;
}
