import {
  DataArrayTexture,
  FloatType,
  HalfFloatType,
  LinearFilter,
  LinearMipmapLinearFilter,
  NearestFilter,
  RedFormat,
  RGBAFormat,
  UnsignedByteType,
} from 'three';
import type { PuffLayers } from '../puffs/layers.ts';
import type { StartCaps } from '../puffs/startCaps.ts';

/** A volume reaches to the ends of the puff's lobes, beyond its mean radius: no light leaks between neighbouring puffs. */
export const SHADOW_SHARE = 1.15;

/** Puffs as plain data: what the bodies show, and where volumes may begin. */
export interface BakedPuffs {
  readonly layers: PuffLayers;
  readonly startCaps: StartCaps;
}

/** The puffs as the body and volume shaders read them: one layer for each variation. */
export class PuffTextures {
  readonly layers: PuffLayers;
  readonly normalDepth: DataArrayTexture;
  readonly colorCoverage: DataArrayTexture;
  readonly startCaps: DataArrayTexture;

  /** @param context decides which filters there are */
  constructor(context: WebGL2RenderingContext, { layers, startCaps }: BakedPuffs) {
    this.layers = layers;
    this.normalDepth = new DataArrayTexture(layers.normalDepth, layers.size, layers.size, layers.count);
    this.normalDepth.format = RGBAFormat;
    this.normalDepth.type = HalfFloatType;
    // Half floats are filtered everywhere, but only contexts that can draw to them can make their smaller levels.
    smooth(this.normalDepth, context.getExtension('EXT_color_buffer_float') !== null);
    this.colorCoverage = new DataArrayTexture(layers.colorCoverage, layers.size, layers.size, layers.count);
    this.colorCoverage.format = RGBAFormat;
    this.colorCoverage.type = UnsignedByteType;
    smooth(this.colorCoverage, true);
    this.startCaps = new DataArrayTexture(startCaps.values, startCaps.width, startCaps.height, layers.count);
    this.startCaps.format = RedFormat;
    this.startCaps.type = FloatType;
    this.startCaps.minFilter = NearestFilter;
    this.startCaps.magFilter = NearestFilter;
    this.startCaps.needsUpdate = true;
  }

  /** Factor on a particle's radius that makes the sphere which holds all of its puff. */
  get reach(): number {
    return Math.max(...this.layers.figures.map(({ outerRadius, relief }) => Math.max(outerRadius, relief)));
  }

  /** Radius of a particle's shadow volume in radii of the particle. */
  get shadowRadius(): number {
    const { figures } = this.layers;
    return (SHADOW_SHARE * figures.reduce((sum, { silhouetteRadius }) => sum + silhouetteRadius, 0)) / figures.length;
  }

  dispose(): void {
    this.normalDepth.dispose();
    this.colorCoverage.dispose();
    this.startCaps.dispose();
  }
}

function smooth(texture: DataArrayTexture, withMipmaps: boolean): void {
  texture.magFilter = LinearFilter;
  texture.minFilter = withMipmaps ? LinearMipmapLinearFilter : LinearFilter;
  texture.generateMipmaps = withMipmaps;
  texture.needsUpdate = true;
}
