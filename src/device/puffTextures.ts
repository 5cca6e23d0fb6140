import {
  DataArrayTexture,
  DataTexture,
  FloatType,
  HalfFloatType,
  LinearFilter,
  LinearMipmapLinearFilter,
  NearestFilter,
  RedFormat,
  RGBAFormat,
  UnsignedByteType,
} from 'three';
import type { Casters } from '../puffs/casters.ts';
import type { LobePuffs } from '../puffs/bakeLobes.ts';
import type { PuffLayers } from '../puffs/layers.ts';
import type { PuffSolids } from '../puffs/solids.ts';
import type { StartCaps } from '../puffs/startCaps.ts';
import { Shared } from './shared.ts';

/** What a puff is on the screen: lobes met per pixel, or the paper's billboards, baked from one side. */
export type PuffForm = 'lobes' | 'billboards';

/** Billboards as plain data: what the bodies show, and where volumes may begin. */
export interface BillboardPuffs {
  readonly layers: PuffLayers;
  readonly startCaps: StartCaps;
  readonly latestCap: number;
  readonly casters: Casters;
  readonly solids: PuffSolids;
}

/** Puffs as plain data in each form. Each may be made when it is first asked for. */
export interface BakedPuffs {
  readonly lobes: LobePuffs;
  readonly billboards: BillboardPuffs;
}

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
interface FormTextures extends PuffExtents {
  /** See `latestCap` in src/puffs/startCaps.ts. */
  readonly latestCap: number;
  /** A layer for each variation. */
  readonly startCaps: DataArrayTexture;
  /** A row for each variation: the lobes that the light meets, centre and radius, and how many of them count. */
  readonly casterTable: DataTexture;
  readonly casterLobes: number;
}

/** The textures of all puffs on one device: smokes that show the same puffs share them. */
export class PuffLibrary {
  readonly lobes = new Shared((puffs: LobePuffs) => new LobeTextures(puffs));
  readonly billboards: Shared<BillboardPuffs, BillboardTextures>;

  /** @param context decides which filters there are */
  constructor(context: WebGL2RenderingContext) {
    this.billboards = new Shared((puffs) => new BillboardTextures(context, puffs));
  }

  /** Lets go of what is on the graphics card; what is drawn again is uploaded anew. */
  dispose(): void {
    this.lobes.dispose();
    this.billboards.dispose();
  }
}

/** The puffs of one smoke as the body and volume shaders read them. A form that is not drawn takes no memory. */
export class PuffTextures {
  private readonly library: PuffLibrary;
  private puffs: BakedPuffs;
  private lobeTextures: LobeTextures | undefined;
  private billboardTextures: BillboardTextures | undefined;

  constructor(library: PuffLibrary, puffs: BakedPuffs) {
    this.library = library;
    this.puffs = puffs;
  }

  get lobes(): LobeTextures {
    this.lobeTextures ??= this.library.lobes.hold(this.puffs.lobes);
    return this.lobeTextures;
  }

  get billboards(): BillboardTextures {
    this.billboardTextures ??= this.library.billboards.hold(this.puffs.billboards);
    return this.billboardTextures;
  }

  of(form: PuffForm): FormTextures {
    return form === 'lobes' ? this.lobes : this.billboards;
  }

  /** Goes over to other puffs; who draws them asks again with `of`. */
  show(puffs: BakedPuffs): void {
    this.dispose();
    this.puffs = puffs;
  }

  /** Gives back what it holds; what is asked for again is held anew. */
  dispose(): void {
    if (this.lobeTextures) this.library.lobes.release(this.puffs.lobes);
    if (this.billboardTextures) this.library.billboards.release(this.puffs.billboards);
    this.lobeTextures = this.billboardTextures = undefined;
  }
}

/** A row of numbers for each variation. */
class LobeTextures implements FormTextures {
  readonly puffs: LobePuffs;
  readonly lobeTable: DataTexture;
  readonly startCaps: DataArrayTexture;
  readonly capRange: readonly [number, number];
  readonly capTable: StartCaps;
  readonly solids: PuffSolids;

  constructor(puffs: LobePuffs) {
    this.puffs = puffs;
    this.lobeTable = new DataTexture(puffs.table, puffs.lobeCount + 1, puffs.count, RGBAFormat, FloatType);
    this.lobeTable.needsUpdate = true;
    this.startCaps = capTexture(puffs.startCaps);
    this.capRange = capRange(puffs.startCaps);
    this.capTable = puffs.startCaps;
    this.solids = puffs.solids;
  }

  get latestCap(): number {
    return this.puffs.latestCap;
  }

  get casterTable(): DataTexture {
    return this.lobeTable;
  }

  get casterLobes(): number {
    return this.puffs.lobeCount;
  }

  get reach(): number {
    return this.puffs.reach;
  }

  get depth(): number {
    return this.puffs.depth;
  }

  dispose(): void {
    this.lobeTable.dispose();
    this.startCaps.dispose();
  }
}

/** A layer for each variation. */
class BillboardTextures implements FormTextures {
  readonly layers: PuffLayers;
  readonly normalDepth: DataArrayTexture;
  readonly colorCoverage: DataArrayTexture;
  readonly startCaps: DataArrayTexture;
  readonly latestCap: number;
  readonly casterTable: DataTexture;
  readonly casterLobes: number;
  readonly capRange: readonly [number, number];
  readonly capTable: StartCaps;
  readonly solids: PuffSolids;

  constructor(context: WebGL2RenderingContext, { layers, startCaps, latestCap, casters, solids }: BillboardPuffs) {
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
    this.startCaps = capTexture(startCaps);
    this.latestCap = latestCap;
    this.casterLobes = casters.lobeCount;
    this.casterTable = new DataTexture(casters.table, casters.lobeCount, casters.count, RGBAFormat, FloatType);
    this.casterTable.needsUpdate = true;
    this.capRange = capRange(startCaps);
    this.capTable = startCaps;
    this.solids = solids;
  }

  /** The relief begins at the centre plane. */
  readonly depth = 0;

  get reach(): number {
    return Math.max(...this.layers.figures.map(({ outerRadius, relief }) => Math.max(outerRadius, relief)));
  }

  dispose(): void {
    this.normalDepth.dispose();
    this.colorCoverage.dispose();
    this.startCaps.dispose();
    this.casterTable.dispose();
  }
}

function capRange({ values }: StartCaps): [number, number] {
  return values.reduce<[number, number]>(([least, most], cap) => [Math.min(least, cap), Math.max(most, cap)], [0, 0]);
}

function capTexture({ values, width, height, count }: StartCaps): DataArrayTexture {
  const texture = new DataArrayTexture(values, width, height, count);
  texture.format = RedFormat;
  texture.type = FloatType;
  texture.minFilter = NearestFilter;
  texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}

function smooth(texture: DataArrayTexture, withMipmaps: boolean): void {
  texture.magFilter = LinearFilter;
  texture.minFilter = withMipmaps ? LinearMipmapLinearFilter : LinearFilter;
  texture.generateMipmaps = withMipmaps;
  texture.needsUpdate = true;
}
