import type { DataArrayTexture, DataTexture } from 'three';
import type { StartCaps } from '../puffs/bake/startCaps.ts';
import type { PuffSolids } from '../puffs/bake/solids.ts';
import type { CasterTable } from '../puffs/billboards/casters.ts';
import type { PuffLayers } from '../puffs/billboards/layers.ts';

/** How far puffs of one form and their shadows reach, in radii of the particle. */
export interface PuffExtents {
  /** Factor on a particle's radius that makes the sphere which holds all of its puff. */
  readonly reach: number;
  /** How deep behind the centre plane something of a puff can be seen, in radii of the particle. */
  readonly depth: number;
  /** How far behind the centre shadow volumes begin, at least and at most, as the table says. */
  readonly capRange: readonly [number, number];
  readonly capTable: StartCaps;
  readonly solids: PuffSolids;
}

/** What all that draws asks of the puffs in one form. */
export interface FormTextures extends PuffExtents {
  /** See `latestCap` in src/puffs/bake/startCaps.ts. */
  readonly latestCap: number;
  /** A layer for each variation. */
  readonly startCaps: DataArrayTexture;
  /** A row for each variation: the lobes that the light meets, centre and radius, and how many of them count. */
  readonly casterTable: DataTexture;
  readonly casterLobes: number;
}

/** Billboards as plain data: what the bodies show, and where volumes may begin. */
export interface BillboardData extends Pick<PuffExtents, 'reach' | 'depth' | 'solids'> {
  readonly layers: PuffLayers;
  readonly startCaps: StartCaps;
  readonly latestCap: number;
  readonly casters: CasterTable;
}
