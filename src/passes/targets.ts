import {
  DepthStencilFormat,
  DepthTexture,
  NearestFilter,
  NoColorSpace,
  RedFormat,
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
  /** A texture, so that other passes can read it or attach it. A pass that renders to the target must not sample it. */
  readonly depth = depthStencil();
  // three.js disposes of a depth texture with the first target that it was given to. This one is always allocated.
  private readonly target = target(2, this.depth);
  /**
   * The target with a third colour, 8 bits of red: the number of the group of the nearest surface. Allocated on first
   * use.
   */
  private readonly numbered = target(3, this.depth);
  private readonly copy = depthCopy();

  constructor() {
    const { textures } = this.numbered;
    textures.splice(0, 2, ...this.target.textures);
    textures[2].format = RedFormat;
  }

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
    this.numbered.setSize(width, height);
  }

  /**
   * Binds the target and clears it: colours to transparent black, depth to far, stencil to zero.
   * @param isNumbered also binds the numbers of groups, until `endNumbers`
   */
  begin(renderer: WebGLRenderer, isNumbered = false): void {
    // three.js reallocates the shared buffers when it first binds a target.
    if (isNumbered) renderer.initRenderTarget(this.target);
    renderer.setRenderTarget(isNumbered ? this.numbered : this.target);
    renderer.setClearColor(0x000000, 0);
    renderer.clear(true, true, true);
  }

  /** Binds the target without the numbers of groups, and returns them: number / 255, 0 without a surface. */
  endNumbers(renderer: WebGLRenderer): Texture {
    renderer.setRenderTarget(this.target);
    return this.numbered.textures[2];
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
    this.numbered.dispose();
    this.target.dispose();
    this.copy.dispose();
  }
}

function target(count: number, depthTexture: DepthTexture): WebGLRenderTarget {
  return new WebGLRenderTarget(1, 1, {
    count,
    type: UnsignedByteType,
    colorSpace: NoColorSpace,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    generateMipmaps: false,
    depthBuffer: true,
    stencilBuffer: true,
    depthTexture,
  });
}

function depthStencil(): DepthTexture {
  const texture = new DepthTexture(1, 1, UnsignedInt248Type);
  texture.format = DepthStencilFormat;
  return texture;
}
