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

/**
 * What the passes draw into: two display-encoded colours with one depth and stencil.
 * Colour 0 is unlit (as in shadow) with the alpha of the page; colour 1 is lit with the shadow mask in alpha.
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
    // As a texture, so that what draws elsewhere can read it or share it.
    depthTexture: depthStencil(),
  });

  /** What is drawn into, for whoever wants to read more of it than the colours. */
  get renderTarget(): WebGLRenderTarget {
    return this.target;
  }

  get unlit(): Texture {
    return this.target.textures[0];
  }

  get lit(): Texture {
    return this.target.textures[1];
  }

  /** Depth and stencil; a pass that draws into the target must not read it. */
  get depth(): DepthTexture {
    return this.target.depthTexture!;
  }

  get width(): number {
    return this.target.width;
  }

  get height(): number {
    return this.target.height;
  }

  /** @param width, height in pixels, at least 1 */
  resize(width: number, height: number): void {
    this.target.setSize(width, height);
  }

  /** Makes both colours transparent black, depth far and the stencil zero, and draws into them from here on. */
  begin(renderer: WebGLRenderer): void {
    renderer.setRenderTarget(this.target);
    renderer.setClearColor(0x000000, 0);
    renderer.clear(true, true, true);
  }

  dispose(): void {
    this.target.dispose();
  }
}

function depthStencil(): DepthTexture {
  const texture = new DepthTexture(1, 1, UnsignedInt248Type);
  texture.format = DepthStencilFormat;
  return texture;
}
