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

/**
 * The render target of the passes: two display-encoded colours with one depth and stencil buffer. Colour 0 is unlit (in
 * shadow) with the alpha of the page; colour 1 is lit with the shadow mask in alpha.
 */
export class Targets {
  /** A texture, so that other passes can read it or attach it. A pass that renders to the target must not sample it. */
  readonly depth: DepthTexture = depthStencil();
  // three.js disposes of a depth texture with the first target that it was given to. This one is always allocated.
  private readonly target = target(2, this.depth);
  /**
   * The target with a third colour, 8 bits of red: the number of the group of the nearest surface. Allocated on first
   * use.
   */
  private readonly numbered = target(3, this.depth);
  /** The target with a third colour of four channels: shaders/lib/shading.glsl. Allocated on first use. */
  private readonly shaded = target(3, this.depth);
  /** The target with the shading and a fourth colour of four channels: shaders/patterns/place.glsl. Allocated on first use. */
  private readonly placed = target(4, this.depth);
  private isPlaced = false;
  private readonly copy = depthCopy();

  constructor() {
    for (const { textures } of [this.numbered, this.shaded]) textures.splice(0, 2, ...this.target.textures);
    this.numbered.textures[2].format = RedFormat;
    this.placed.textures.splice(0, 3, ...this.shaded.textures);
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
    for (const each of this.all) each.setSize(width, height);
  }

  /**
   * Binds the target and clears it: colours to transparent black, depth to far, stencil to zero.
   * @param isNumbered also binds the numbers of groups, until `endNumbers`
   * @param isShaded also clears the shading, for `beginShading`
   * @param isPlaced also clears the places on puffs, if `isShaded`
   */
  begin(renderer: WebGLRenderer, isNumbered = false, isShaded = false, isPlaced = false): void {
    // three.js reallocates the shared buffers when it first binds a target.
    if (isNumbered || isShaded) renderer.initRenderTarget(this.target);
    if (isNumbered && isShaded) renderer.initRenderTarget(this.numbered);
    renderer.setClearColor(0x000000, 0);
    this.isPlaced = isShaded && isPlaced;
    if (this.isPlaced) renderer.initRenderTarget(this.shaded);
    if (isShaded) this.clear(renderer, this.withShading);
    // The shaded target has all buffers of the other two but the numbers.
    if (isShaded && !isNumbered) renderer.setRenderTarget(this.target);
    else this.clear(renderer, isNumbered ? this.numbered : this.target);
  }

  /** Binds the target without the numbers of groups, and returns them: number / 255, 0 without a surface. */
  endNumbers(renderer: WebGLRenderer): Texture {
    renderer.setRenderTarget(this.target);
    return this.numbered.textures[2];
  }

  /** The places on puffs. */
  get places(): Texture {
    return this.placed.textures[3];
  }

  /** Binds the target with the shading of smoke, until `endShading`. */
  beginShading(renderer: WebGLRenderer): void {
    renderer.setRenderTarget(this.withShading);
  }

  /** Binds the target without the shading, and returns it. */
  endShading(renderer: WebGLRenderer): Texture {
    renderer.setRenderTarget(this.target);
    return this.shaded.textures[2];
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
    for (const each of [...this.all, this.copy]) each.dispose();
  }

  private get withShading(): WebGLRenderTarget {
    return this.isPlaced ? this.placed : this.shaded;
  }

  private get all(): readonly WebGLRenderTarget[] {
    return [this.placed, this.shaded, this.numbered, this.target];
  }

  private clear(renderer: WebGLRenderer, cleared: WebGLRenderTarget): void {
    renderer.setRenderTarget(cleared);
    renderer.clear(true, true, true);
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

/** A render target for display-encoded colours that are read by texelFetch; 1 x 1 until it is resized. */
export function pictureTarget(count = 1): WebGLRenderTarget {
  return new WebGLRenderTarget(1, 1, {
    count,
    colorSpace: NoColorSpace,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    generateMipmaps: false,
    depthBuffer: false,
  });
}

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
