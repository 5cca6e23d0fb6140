import { DataTexture, FloatType, RGBAFormat, type DataArrayTexture } from 'three';
import type { LobePuffs } from '../puffs/bake/bakeLobes.ts';
import type { PuffSolids } from '../puffs/bake/solids.ts';
import type { StartCaps } from '../puffs/bake/startCaps.ts';
import type { BillboardTextures } from './billboardTextures.ts';
import { capRange, capTexture } from './capTexture.ts';
import { Shared } from './shared.ts';
import type { BillboardData, FormTextures } from './formTextures.ts';

/** What a puff is on the screen: lobes met per pixel, or the paper's billboards, baked from one side. */
export type PuffForm = 'lobes' | 'billboards';

/** Billboards as plain data, and how they come to the graphics card. */
export interface BillboardPuffs extends BillboardData {
  /** The context decides which filters there are. */
  texturesFor(context: WebGL2RenderingContext): BillboardTextures;
}

/** Puffs as plain data in each form. Each may be made when it is first asked for. */
export interface BakedPuffs {
  readonly lobes: LobePuffs;
  /** @throws LoadError before anybody has fetched the code of billboards, as a style does that asks for them */
  readonly billboards: BillboardPuffs;
}

/** The textures of all puffs on one device: smokes that show the same puffs share them. */
export class PuffLibrary {
  readonly lobes = new Shared((puffs: LobePuffs) => new LobeTextures(puffs));
  readonly billboards: Shared<BillboardPuffs, BillboardTextures>;

  /** @param context decides which filters there are */
  constructor(context: WebGL2RenderingContext) {
    this.billboards = new Shared((puffs) => puffs.texturesFor(context));
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
