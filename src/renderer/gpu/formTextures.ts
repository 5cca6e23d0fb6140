import { DataArrayTexture, type DataTexture, FloatType, NearestFilter, type RawShaderMaterial, RedFormat } from 'three';
import type { StartCaps } from '../puffs/bake/startCaps.ts';
import type { PuffSolids } from '../puffs/bake/solids.ts';
import type { CasterTable } from '../puffs/billboards/casters.ts';
import type { PuffLayers } from '../puffs/billboards/layers.ts';

/** Bounds of the puffs of one form and their shadows, in radii of the particle. */
export interface PuffExtents {
  /** Radius of the bounding sphere of all puffs. */
  readonly reach: number;
  /** Greatest factor by which lobes are farther from the centre than in the baked shape. */
  readonly spread: number;
  /** Largest distance behind the centre plane at which a part of a puff is visible. */
  readonly depth: number;
  /** Least and greatest distance behind the centre at which shadow volumes start. */
  readonly capRange: readonly [number, number];
  /** The baked table; absent if puffs turn, stretch or unfold. */
  readonly capTable?: StartCaps;
  readonly solids: PuffSolids;
  /** Sides from which each variation is drawn, default 1. Tables have an entry for each side. */
  readonly sides?: number;
  /** The solids of shadows, if they are not those of bodies. */
  readonly casterSolids?: PuffSolids;
}

/** Textures and bounds of the puffs of one form, as all passes use them. */
export interface FormTextures extends PuffExtents {
  /** See `latestCap` in src/renderer/puffs/bake/startCaps.ts. */
  readonly latestCap: number;
  /** Array texture of the table, with a layer for each variation. */
  readonly startCaps?: DataArrayTexture;
  /** One row for each variation: centre and radius of the lobes that cast shadow. The first `casterLobes` count. */
  readonly casterTable: DataTexture;
  readonly casterLobes: number;
  /**
   * Makes the volumes of a material those of silhouettes. Each lobe that casts shadow contains one. Absent if the whole lobes cast
   * shadow.
   */
  readonly silhouettes?: ((material: RawShaderMaterial) => void) | undefined;
}

/** Billboards as plain data: the layers to draw and the tables of their shadow volumes. */
export interface BillboardData extends Pick<PuffExtents, 'reach' | 'depth' | 'sides' | 'solids' | 'casterSolids'> {
  readonly layers: PuffLayers;
  readonly startCaps: StartCaps;
  readonly latestCap: number;
  readonly casters: CasterTable;
}

/** The start caps of shadow volumes as a texture: see `src/renderer/puffs/bake/startCaps.ts`. */

/** The least and the greatest start cap, with 0 included. */
export function capRange({ values }: StartCaps): [number, number] {
  return values.reduce<[number, number]>(([min, max], cap) => [Math.min(min, cap), Math.max(max, cap)], [0, 0]);
}

/** An array texture with a layer for each variation. */
export function capTexture({ values, width, height, count }: StartCaps): DataArrayTexture {
  const texture = new DataArrayTexture(values, width, height, count);
  texture.format = RedFormat;
  texture.type = FloatType;
  texture.minFilter = NearestFilter;
  texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}
