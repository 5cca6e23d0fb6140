import type { BakedPuffs } from '../device/puffTextures.ts';
import type { Values } from '../preset/parameter.ts';
import { designedShapes, type PuffDesign } from '../puffs/lobeShapes.ts';
import type { PuffShape } from '../puffs/shapes.ts';
import { finished, workedFor, type Work } from '../puffs/work.ts';
import { bakingPuffs } from './bakedPuffs.ts';

/** What to bake, and a text that is the same for the same puffs. */
interface PuffRequest {
  readonly key: string;
  begin(): Work<BakedPuffs>;
}

/**
 * The puffs that values describe. When their knobs turn, others are baked a little with each picture, while the old ones stand;
 * who keeps turning sees those that were asked for when the bakery was last free.
 */
export class LivePuffs {
  private own: readonly PuffShape[] | undefined;
  private variations = 1;
  private wanted: PuffRequest;
  private standing = '';
  private baking: { readonly key: string; readonly work: Work<BakedPuffs> } | undefined;

  constructor(values: Values) {
    this.wanted = this.requestOf(values);
  }

  /** The shapes that somebody brought, if anybody has. */
  get ownShapes(): readonly PuffShape[] | undefined {
    return this.own;
  }

  /**
   * Asks for the puffs that values describe. Variations never become fewer: a particle keeps the one it was born with.
   * @param alive variations that living particles may have
   */
  follow(values: Values, alive = 0): void {
    this.variations = Math.max(this.variations, alive);
    this.wanted = this.requestOf(values);
  }

  /** Asks for shapes that somebody brought, or again for those that values describe. */
  use(own: readonly PuffShape[] | undefined, values: Values): void {
    this.own = own;
    this.follow(values);
  }

  /** Goes on baking for some milliseconds. Returns new puffs when they are ready. */
  workFor(milliseconds: number): BakedPuffs | undefined {
    if (!this.begin()) return undefined;
    return this.taken(workedFor(this.baking!.work, milliseconds));
  }

  /** Bakes what was last asked for. Returns new puffs unless they stand already. */
  finish(): BakedPuffs | undefined {
    if (this.baking?.key !== this.wanted.key) this.baking = undefined;
    return this.begin() ? this.taken(finished(this.baking!.work)) : undefined;
  }

  /** Whether there is something to bake. */
  private begin(): boolean {
    const { key } = this.wanted;
    if (!this.baking && key !== this.standing) this.baking = { key, work: this.wanted.begin() };
    return this.baking !== undefined;
  }

  private taken(puffs: BakedPuffs | undefined): BakedPuffs | undefined {
    if (!puffs) return undefined;
    this.standing = this.baking!.key;
    this.baking = undefined;
    return puffs;
  }

  private requestOf(values: Values): PuffRequest {
    this.variations = Math.max(this.variations, values['puff.variations'] as number);
    const { own, variations } = this;
    const design = designOf(values);
    return {
      key: JSON.stringify(own ?? [design, variations]),
      begin: () => bakingPuffs(own ?? designedShapes(design, variations), showsBillboards(values)),
    };
  }
}

/** Whether puffs are drawn as billboards, which take longer to bake than lobes. */
export function showsBillboards(values: Values): boolean {
  return values['puff.form'] === 'billboards' || values['style.renderer'] === 'selle';
}

function designOf(values: Values): PuffDesign {
  const knobs = ['lumpiness', 'flatness', 'roughness', 'lobes', 'seed'] satisfies (keyof PuffDesign)[];
  return Object.fromEntries(knobs.map((knob) => [knob, values[`puff.${knob}`]])) as Record<keyof PuffDesign, number>;
}
