import {
  type RawShaderMaterial,
  type WebGLRenderer,
  NearestFilter,
  RGIntegerFormat,
  UnsignedIntType,
  WebGLRenderTarget,
  type Texture,
} from 'three';
import vertexShader from '../../../../shaders/tiledVolumes/tiledVolumes.vert';
import type { RowGeometry } from '../../gpu/drawnRows.ts';
import type { FrameView } from '../../gpu/frameView.ts';
import { withLobes, type Shaders } from '../../gpu/programsAhead.ts';
import type { PuffTextures } from '../../gpu/puffTextures.ts';
import type { Targets } from '../targets.ts';
import { VolumesPass } from '../volumes.ts';
import { VolumeQuads } from './volumeQuads.ts';
import fragmentShader from '../../../../shaders/tiledVolumes/depthRanges.frag';
import { DEPTH_TILE } from '../../../base/constants.ts';
import { FullScreen } from '../../gpu/fullScreen.ts';

/**
 * Draws the same shadow volumes as `VolumesPass`, for cameras close to puffs: large volumes in tiles, without the tiles
 * whose receivers they cannot contain.
 */
export class TiledVolumesPass extends VolumesPass {
  private readonly eye: FrameView;
  private readonly ranges: DepthRanges;
  private tiled: VolumeQuads | undefined;

  constructor(eye: FrameView, puffs: PuffTextures) {
    super(eye, puffs);
    this.eye = eye;
    this.ranges = new DepthRanges(eye);
    this.uniforms.depthRanges = { value: this.ranges.texture };
    this.uniforms.volumeQuads = { value: null };
  }

  /**
   * @param casters rows of the casters
   * @param limit count at which a pixel is dark enough, 1..255
   */
  drawTiles(renderer: WebGLRenderer, casters: RowGeometry, targets: Targets, limit: number): void {
    const quads = this.find(renderer, casters, targets);
    this.draw(renderer, quads, targets.copyDepth(renderer), limit);
  }

  /** Repeats the last draw with a variant of the material. */
  drawTilesAs(renderer: WebGLRenderer, material: RawShaderMaterial): void {
    if (this.tiled) this.drawAs(renderer, material, this.tiled);
  }

  override dispose(): void {
    super.dispose();
    this.ranges.dispose();
    this.tiled?.dispose();
  }

  protected override shadersWith(lobes: number, isDeformed: boolean): Shaders {
    return { ...super.shadersWith(lobes, isDeformed), vertexShader: withLobes(vertexShader, lobes) };
  }

  private find(renderer: WebGLRenderer, { rows }: RowGeometry, targets: Targets): VolumeQuads {
    if (this.tiled?.rows !== rows) {
      this.tiled?.dispose();
      this.tiled = new VolumeQuads(rows);
    }
    this.tiled.find(this.eye, this.form.reach.value);
    if (this.tiled.hasTiles) this.ranges.measure(renderer, targets);
    else this.ranges.prepare(renderer);
    return this.tiled;
  }
}

/**
 * Nearest and farthest depth in each tile of the picture: one level of a hierarchical depth buffer (Greene, Kass and
 * Miller, 'Hierarchical Z-Buffer Visibility', 1993).
 */
class DepthRanges {
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
