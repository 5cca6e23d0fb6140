import {
  DataArrayTexture,
  DataTexture,
  FloatType,
  HalfFloatType,
  LinearFilter,
  LinearMipmapLinearFilter,
  RedFormat,
  type IUniform,
  type RawShaderMaterial,
  RGBAFormat,
  UnsignedByteType,
} from 'three';
import countedFragment from '../../../shaders/silhouettes/countedVolumesFragment.glsl';
import volumeVertex from '../../../shaders/silhouettes/volumeVertex.glsl';
import volumesFragment from '../../../shaders/silhouettes/volumesFragment.glsl';
import type { PuffLayers } from '../puffs/billboards/layers.ts';
import type { PuffSolids } from '../puffs/bake/solids.ts';
import type { StartCaps } from '../puffs/bake/startCaps.ts';
import { capRange, capTexture, type BillboardData, type FormTextures } from './formTextures.ts';
import { withCodeBeforeMain } from './programsAhead.ts';

/** Baked billboards as array textures, with a layer for each side of each variation. */
export class BillboardTextures implements FormTextures {
  readonly layers: PuffLayers;
  readonly normalDepth: DataArrayTexture;
  readonly colorCoverage: DataArrayTexture;
  /** Uniforms of the shaders of bodies. */
  readonly uniforms: Readonly<Record<string, IUniform>>;
  readonly startCaps: DataArrayTexture;
  readonly latestCap: number;
  readonly spread = 1;
  readonly casterTable: DataTexture;
  readonly casterLobes: number;
  private readonly supports: DataTexture;
  readonly silhouettes: FormTextures['silhouettes'];
  readonly capRange: readonly [number, number];
  readonly capTable: StartCaps;
  readonly solids: PuffSolids;
  readonly casterSolids?: PuffSolids;
  readonly sides?: number;
  readonly reach: number;
  readonly depth: number;

  constructor(
    context: WebGL2RenderingContext,
    { layers, startCaps, latestCap, casters, solids, casterSolids, sides, reach, depth }: BillboardData,
  ) {
    this.layers = layers;
    this.normalDepth = new DataArrayTexture(layers.normalDepth, layers.size, layers.size, layers.count);
    this.normalDepth.format = RGBAFormat;
    const isBytes = layers.normalDepth instanceof Uint8Array;
    this.normalDepth.type = isBytes ? UnsignedByteType : HalfFloatType;
    // Half-float textures can be filtered in every context, but mipmap generation needs a color-renderable format.
    smooth(this.normalDepth, isBytes || context.getExtension('EXT_color_buffer_float') !== null);
    this.colorCoverage = new DataArrayTexture(layers.colorCoverage, layers.size, layers.size, layers.count);
    this.colorCoverage.format = RGBAFormat;
    this.colorCoverage.type = UnsignedByteType;
    smooth(this.colorCoverage, true);
    this.supports = supportTexture(layers);
    this.uniforms = {
      normalDepth: { value: this.normalDepth },
      colorCoverage: { value: this.colorCoverage },
      pad: { value: layers.pad },
      distanceRange: { value: layers.distanceRange },
      supports: { value: this.supports },
    };
    this.startCaps = capTexture(startCaps);
    this.latestCap = latestCap;
    this.casterLobes = casters.lobeCount;
    this.casterTable = new DataTexture(casters.table, casters.lobeCount, casters.count, RGBAFormat, FloatType);
    this.casterTable.needsUpdate = true;
    this.silhouettes = casters.silhouetteReach > 0 ? (material) => this.addSilhouettes(material) : undefined;
    this.capRange = capRange(startCaps);
    this.capTable = startCaps;
    this.solids = solids;
    this.casterSolids = casterSolids;
    this.sides = sides;
    this.reach = reach;
    this.depth = depth;
  }

  dispose(): void {
    this.normalDepth.dispose();
    this.colorCoverage.dispose();
    this.startCaps.dispose();
    this.casterTable.dispose();
    this.supports.dispose();
  }

  /** Appends the functions that the shaders of volumes declare for CUT, or those of counted volumes for SILHOUETTE. */
  private addSilhouettes(material: RawShaderMaterial): void {
    Object.assign(material.uniforms, this.uniforms, { silhouettes: { value: this.colorCoverage } });
    if ('SILHOUETTE' in material.defines) return;
    const isCounted = material.fragmentShader.includes('SILHOUETTE');
    Object.assign(material.defines, { CUT: '', SILHOUETTE: '' });
    material.vertexShader = withCodeBeforeMain(material.vertexShader, volumeVertex);
    const code = isCounted ? countedFragment : volumesFragment;
    material.fragmentShader = withCodeBeforeMain(material.fragmentShader, code);
  }
}

/** For shaders/silhouettes/support.glsl. */
function supportTexture({ figures, count, pad, size }: PuffLayers): DataTexture {
  // Filtering moves the silhouette by less than a texel.
  const slack = (2 * pad) / size;
  const values = figures.flatMap(({ supports }) => Array.from(supports, (extent) => extent + slack));
  const texture = new DataTexture(Float32Array.from(values), values.length / count, count, RedFormat, FloatType);
  texture.needsUpdate = true;
  return texture;
}

function smooth(texture: DataArrayTexture, withMipmaps: boolean): void {
  texture.magFilter = LinearFilter;
  texture.minFilter = withMipmaps ? LinearMipmapLinearFilter : LinearFilter;
  texture.generateMipmaps = withMipmaps;
  texture.needsUpdate = true;
}
