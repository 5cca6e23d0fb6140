import type { RawShaderMaterial, WebGLRenderer } from 'three';
import vertexShader from '../../../../shaders/tiledVolumes/tiledVolumes.vert';
import type { RowGeometry } from '../../gpu/drawnRows.ts';
import type { FrameView } from '../../gpu/frameView.ts';
import { withLobes, type Shaders } from '../../gpu/programsAhead.ts';
import type { PuffTextures } from '../../gpu/puffTextures.ts';
import type { Targets } from '../targets.ts';
import { VolumesPass } from '../volumes.ts';
import { DepthRanges } from './depthRanges.ts';
import { VolumeQuads } from './volumeQuads.ts';

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
