import { DataTexture, FloatType, RGBAFormat, type DataArrayTexture } from 'three';
import type { LobePuffs } from '../puffs/bake/bakeLobes.ts';
import type { PuffSolids } from '../puffs/bake/solids.ts';
import type { StartCaps } from '../puffs/bake/startCaps.ts';
import type { BillboardTextures } from './billboardTextures.ts';
import { capRange, capTexture } from './capTexture.ts';
import { Shared } from './shared.ts';
import type { BillboardData, FormTextures } from './formTextures.ts';
import type { BiteShaders, PuffChanges } from './unroll.ts';

/** How a puff is drawn: as lobes that are intersected per pixel, or as the paper's billboards, baked from one side. */
export type PuffForm = 'lobes' | 'billboards';

/** Billboards as plain data, and a factory of their textures. */
export interface BillboardPuffs extends BillboardData {
  /** @param context its extensions decide which texture filters are available */
  texturesFor(context: WebGL2RenderingContext): BillboardTextures;
}

/** Puffs as plain data in each form. A form may be baked on first access. */
export interface BakedPuffs {
  readonly lobes: LobePuffs;
  /** @throws LoadError if the code of billboards was not loaded, which a style with billboards does */
  readonly billboards: BillboardPuffs;
}

/** Varyings of puffs with bites besides those of the lobes. WebGL 2 guarantees 15. */
const VARYINGS_BESIDE_LOBES = 5;

/** The puff textures of a device. Smokes with the same puffs share them. */
export class PuffLibrary {
  readonly lobes = new Shared((puffs: LobePuffs) => new LobeTextures(puffs));
  readonly billboards: Shared<BillboardPuffs, BillboardTextures>;
  /** Vectors that the context can pass from a vertex shader to a fragment shader. */
  private readonly varyings: number;

  /** @param context its extensions decide which texture filters are available */
  constructor(context: WebGL2RenderingContext) {
    this.billboards = new Shared((puffs) => puffs.texturesFor(context));
    this.varyings = context.getParameter(context.MAX_VARYING_VECTORS) as number;
  }

  /** Whether puffs with a number of lobes can have bites on this device. */
  canErode(lobes: number): boolean {
    return lobes + VARYINGS_BESIDE_LOBES <= this.varyings;
  }

  /** Frees all GPU resources. They are uploaded again when they are next drawn. */
  dispose(): void {
    this.lobes.dispose();
    this.billboards.dispose();
  }
}

/** The puff textures of one smoke. A form that is not drawn allocates nothing. */
export class PuffTextures {
  private readonly library: PuffLibrary;
  private puffs: BakedPuffs;
  private deformedBy: number | undefined;
  private bites: BiteShaders | undefined;
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

  /** How lobe puffs differ from their baked shapes. */
  get changes(): PuffChanges {
    const fits = this.library.canErode(this.puffs.lobes.lobeCount);
    return { isDeformed: this.deformedBy !== undefined, bites: fits ? this.bites : undefined };
  }

  /**
   * @param ratio greatest ratio of the axes of lobe puffs; undefined if they have their baked shapes
   * @param bites code of their bites, if they have bites; puffs with more than ten lobes have none on some GPUs
   */
  change(ratio: number | undefined, bites: BiteShaders | undefined): void {
    this.deformedBy = ratio;
    this.bites = bites;
  }

  of(form: PuffForm): FormTextures {
    if (form === 'billboards') return this.billboards;
    const { lobes, deformedBy } = this;
    const whole = deformedBy === undefined ? lobes : deformed(lobes, deformedBy);
    return this.changes.bites ? eroded(whole) : whole;
  }

  /** Replaces the puffs. Passes have to call `of` again. */
  show(puffs: BakedPuffs): void {
    this.dispose();
    this.puffs = puffs;
  }

  /** Releases the textures. The next access holds them again. */
  dispose(): void {
    if (this.lobeTextures) this.library.lobes.release(this.puffs.lobes);
    if (this.billboardTextures) this.library.billboards.release(this.puffs.billboards);
    this.lobeTextures = this.billboardTextures = undefined;
  }
}

/** Factor on the distance of a lobe along the axis of a stretch, by the ratio of the axes. */
export function spreadOf(ratio: number): number {
  return Math.sqrt(ratio);
}

/**
 * Lobe puffs that are up to the root of a ratio longer than in the baked shape. Their shadow volumes start behind the
 * farthest lit point of their lobes, instead of where the table says.
 */
function deformed(lobes: FormTextures, ratio: number): FormTextures {
  const { startCaps, casterTable, casterLobes, capTable, solids } = lobes;
  const spread = spreadOf(ratio);
  const reach = spread * lobes.reach;
  return {
    startCaps,
    casterTable,
    casterLobes,
    capTable,
    reach,
    spread,
    depth: spread * lobes.depth,
    capRange: [0, reach],
    latestCap: 0,
    solids: { ...solids, tolerance: 2 * spread * solids.tolerance },
  };
}

/** Puffs with bites, whose walls are visible, and lit, up to the far end of the puff. */
function eroded(form: FormTextures): FormTextures {
  const { startCaps, casterTable, casterLobes, capTable, solids, reach, spread, latestCap } = form;
  const same = { startCaps, casterTable, casterLobes, capTable, solids, reach, spread, latestCap };
  return { ...same, depth: reach, capRange: [form.capRange[0], reach] };
}

/** The lobes of all puffs as a texture, with a row for each variation. */
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

  get spread(): number {
    return 1;
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
