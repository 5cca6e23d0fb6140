import { DataTexture, FloatType, RGBAFormat, type DataArrayTexture } from 'three';
import type { LobePuffs } from '../puffs/bake/bakeLobes.ts';
import type { LobeCaps } from '../puffs/bake/lobeCaps.ts';
import type { PuffSolids } from '../puffs/bake/solids.ts';
import type { StartCaps } from '../puffs/bake/startCaps.ts';
import type { BillboardTextures } from './billboardTextures.ts';
import { capRange, capTexture, type BillboardData, type FormTextures } from './formTextures.ts';
import type { BiteDrawing } from './drawnRows.ts';

/** How a puff is drawn: as lobes that are intersected per pixel, or as the paper's billboards, baked from one side. */
export type PuffForm = 'lobes' | 'billboards';

/** Billboards as plain data, and a factory of their textures. */
export interface BillboardPuffs extends BillboardData {
  /** @param context its extensions decide which texture filters are available */
  texturesFor(context: WebGL2RenderingContext): BillboardTextures;
}

/** Lobe puffs as plain data. */
export interface BakedLobes extends LobePuffs {
  /**
   * Baked on first access.
   * @throws LoadError if their code was not loaded, which a style with puffs that keep their shape does
   */
  readonly caps: LobeCaps;
}

/** Puffs as plain data in each form. A form may be baked on first access. */
export interface BakedPuffs {
  readonly lobes: BakedLobes;
  /** @throws LoadError if the code of billboards was not loaded, which a style with billboards does */
  readonly billboards: BillboardPuffs;
}

/** How puffs with bites differ from whole ones: see src/renderer/bites.ts. */
export interface Bites {
  readonly bodies: BiteDrawing;
  readonly volumes: BiteDrawing;
  formOf(whole: FormTextures): FormTextures;
}

/** The puff textures of a device. Smokes with the same puffs share them. */
export class PuffLibrary {
  readonly lobes = new Shared((puffs: BakedLobes) => new LobeTextures(puffs));
  readonly billboards: Shared<BillboardPuffs, BillboardTextures>;

  /** @param context its extensions decide which texture filters are available */
  constructor(context: WebGL2RenderingContext) {
    this.billboards = new Shared((puffs) => puffs.texturesFor(context));
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
  /** The bites of lobe puffs, if they may have bites. Passes have to call `of` again after a change. */
  bites: Bites | undefined;
  private lobeTextures: LobeTextures | undefined;
  private billboardTextures: BillboardTextures | undefined;

  constructor(library: PuffLibrary, puffs: BakedPuffs) {
    this.library = library;
    this.puffs = puffs;
  }

  get lobes(): LobeTextures {
    this.lobeTextures ??= this.library.lobes.acquire(this.puffs.lobes);
    return this.lobeTextures;
  }

  get billboards(): BillboardTextures {
    this.billboardTextures ??= this.library.billboards.acquire(this.puffs.billboards);
    return this.billboardTextures;
  }

  /** Whether lobe puffs turn or stretch with the air, or unfold. */
  get isDeformed(): boolean {
    return this.deformedBy !== undefined;
  }

  /** @param ratio greatest ratio of the axes of lobe puffs; undefined if they have their baked shapes */
  deform(ratio: number | undefined): void {
    this.deformedBy = ratio;
  }

  of(form: PuffForm): FormTextures {
    if (form === 'billboards') return this.billboards;
    const whole = this.deformedBy === undefined ? this.lobes : deformed(this.lobes, this.deformedBy);
    return this.bites?.formOf(whole) ?? whole;
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
  const { casterTable, casterLobes, solids } = lobes;
  const spread = spreadOf(ratio);
  const reach = spread * lobes.reach;
  return {
    casterTable,
    casterLobes,
    reach,
    spread,
    depth: spread * lobes.depth,
    capRange: [0, reach],
    latestCap: 0,
    solids: { ...solids, tolerance: 2 * spread * solids.tolerance },
  };
}

/** The lobes of all puffs as a texture, with a row for each variation. */
class LobeTextures implements FormTextures {
  readonly puffs: BakedLobes;
  readonly lobeTable: DataTexture;
  readonly solids: PuffSolids;
  // An object, because puffs with bites inherit from this one.
  private readonly caps: { texture?: DataArrayTexture; range?: [number, number] } = {};

  constructor(puffs: BakedLobes) {
    this.puffs = puffs;
    this.lobeTable = new DataTexture(puffs.table, puffs.lobeCount + 1, puffs.count, RGBAFormat, FloatType);
    this.lobeTable.needsUpdate = true;
    this.solids = puffs.solids;
  }

  get startCaps(): DataArrayTexture {
    this.caps.texture ??= capTexture(this.puffs.caps.startCaps);
    return this.caps.texture;
  }

  get capTable(): StartCaps {
    return this.puffs.caps.startCaps;
  }

  get capRange(): [number, number] {
    this.caps.range ??= capRange(this.puffs.caps.startCaps);
    return this.caps.range;
  }

  get latestCap(): number {
    return this.puffs.caps.latestCap;
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
    this.caps.texture?.dispose();
  }
}

interface Held<Item> {
  readonly item: Item;
  holders: number;
}

/** Reference-counted resources of a device: created on first use, disposed of after the last release. */
class Shared<Key extends object, Item extends { dispose(): void }> {
  private readonly make: (key: Key) => Item;
  private readonly held = new Map<Key, Held<Item>>();

  constructor(make: (key: Key) => Item) {
    this.make = make;
  }

  /** Number of distinct resources. */
  get size(): number {
    return this.held.size;
  }

  /** Returns the item of a key. Each call needs a matching `release`. */
  acquire(key: Key): Item {
    const held = this.held.get(key) ?? { item: this.make(key), holders: 0 };
    held.holders += 1;
    this.held.set(key, held);
    return held.item;
  }

  release(key: Key): void {
    const held = this.held.get(key)!;
    held.holders -= 1;
    if (held.holders > 0) return;
    held.item.dispose();
    this.held.delete(key);
  }

  /** Disposes of all items but keeps the references: items recreate their GPU resources when they are next drawn. */
  dispose(): void {
    for (const { item } of this.held.values()) item.dispose();
  }
}
