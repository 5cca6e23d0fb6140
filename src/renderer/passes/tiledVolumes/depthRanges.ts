import {
  NearestFilter,
  RGIntegerFormat,
  UnsignedIntType,
  WebGLRenderTarget,
  type Texture,
  type WebGLRenderer,
} from 'three';
import fragmentShader from '../../../../shaders/tiledVolumes/depthRanges.frag';
import { DEPTH_TILE } from '../../../base/constants.ts';
import type { FrameView } from '../../gpu/frameView.ts';
import { FullScreen } from '../../gpu/fullScreen.ts';
import type { Targets } from '../targets.ts';

/**
 * Nearest and farthest depth in each tile of the picture: one level of a hierarchical depth buffer (Greene, Kass and
 * Miller, 'Hierarchical Z-Buffer Visibility', 1993).
 */
export class DepthRanges {
  private readonly target = new WebGLRenderTarget(1, 1, {
    format: RGIntegerFormat,
    type: UnsignedIntType,
    internalFormat: 'RG32UI',
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    generateMipmaps: false,
    depthBuffer: false,
  });

  private readonly depth = { value: null as Texture | null };
  private readonly pass: FullScreen;

  constructor({ uniforms: { clipFromView } }: FrameView) {
    this.pass = new FullScreen(fragmentShader, { clipFromView, depth: this.depth });
  }

  get texture(): Texture {
    return this.target.texture;
  }

  /** Allocates the texture: one without data does not match its sampler, even if it is not read. */
  prepare(renderer: WebGLRenderer): void {
    const drawnInto = renderer.getRenderTarget();
    renderer.initRenderTarget(this.target);
    renderer.setRenderTarget(drawnInto);
  }

  /** Measures the depth of the targets. Leaves the render target as it is. */
  measure(renderer: WebGLRenderer, { width, height, depth }: Targets): void {
    const drawnInto = renderer.getRenderTarget();
    this.target.setSize(Math.ceil(width / DEPTH_TILE), Math.ceil(height / DEPTH_TILE));
    this.depth.value = depth;
    renderer.setRenderTarget(this.target);
    this.pass.draw(renderer);
    renderer.setRenderTarget(drawnInto);
  }

  dispose(): void {
    this.pass.dispose();
    this.target.dispose();
  }
}
