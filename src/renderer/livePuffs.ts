import type { BakedPuffs } from './gpu/puffTextures.ts';
import type { Values } from '../parameters/parameter.ts';
import { designedShapes, type PuffDesign } from './puffs/lobeShapes.ts';
import { keyOf, type PuffShape } from './puffs/shapes.ts';
import { finished, workedFor, type Work } from '../base/work.ts';
import { bakingPuffs, type PuffParts } from './bakedPuffs.ts';
import { codeOf, loaded } from './extraPasses.ts';
import { deformationOf, formOf } from './style.ts';

/** Puffs to bake; equal puffs have equal keys. */
interface PuffRequest {
  readonly key: string;
  begin(): Work<BakedPuffs>;
}

/**
 * Bakes the puffs that values describe. When the values change, new puffs are baked over several frames while the old
 * ones are drawn. Requests that arrive during a bake replace each other, and the last one starts when the bake ends.
 */
export class LivePuffs {
  private own: readonly PuffShape[] | undefined;
  private variations = 1;
  private wanted: PuffRequest;
  private currentKey = '';
  private baking: { readonly key: string; readonly work: Work<BakedPuffs> } | undefined;

  constructor(values: Values) {
    this.wanted = this.requestOf(values);
  }

  /** The shapes set by `use`, if any. */
  get ownShapes(): readonly PuffShape[] | undefined {
    return this.own;
  }

  /**
   * Requests the puffs that values describe. The number of variations never decreases, because a particle keeps its
   * variation.
   * @param alive number of variations that live particles may have
   */
  requestPuffs(values: Values, alive = 0): void {
    this.variations = Math.max(this.variations, alive);
    this.wanted = this.requestOf(values);
  }

  /** Requests custom shapes, or again the puffs that values describe if `own` is undefined. */
  use(own: readonly PuffShape[] | undefined, values: Values): void {
    this.own = own;
    this.requestPuffs(values);
  }

  /** Bakes for a number of milliseconds. Returns the new puffs when they are ready. */
  workFor(milliseconds: number): BakedPuffs | undefined {
    if (!this.begin()) return undefined;
    return this.adopted(workedFor(this.baking!.work, milliseconds));
  }

  /** Completes the last request synchronously. Returns the new puffs, or undefined if they are already in use. */
  finish(): BakedPuffs | undefined {
    if (this.baking?.key !== this.wanted.key) this.baking = undefined;
    return this.begin() ? this.adopted(finished(this.baking!.work)) : undefined;
  }

  /** Starts a bake if one is requested. Returns whether there is work to do. */
  private begin(): boolean {
    const { key } = this.wanted;
    if (!this.baking && key !== this.currentKey) this.baking = { key, work: this.wanted.begin() };
    return this.baking !== undefined;
  }

  private adopted(puffs: BakedPuffs | undefined): BakedPuffs | undefined {
    if (!puffs) return undefined;
    this.currentKey = this.baking!.key;
    this.baking = undefined;
    return puffs;
  }

  private requestOf(values: Values): PuffRequest {
    this.variations = Math.max(this.variations, values['puff.variations'] as number);
    const { own, variations } = this;
    const design = designOf(values);
    const parts = partsOf(values);
    const drawing = own ? '' : values['puff.drawing'];
    // While the code is not loaded, the last picture stays, and these puffs are not drawn.
    const isDrawn = () => drawing && loaded.billboards;
    const undrawn = own ? keyOf(own) : JSON.stringify([design, variations]);
    return {
      get key() {
        return `${parts.precision} ${parts.sides} ${isDrawn() ? drawing : undrawn}`;
      },
      begin: () =>
        isDrawn() ? bakingDrawn(drawing!, parts) : bakingPuffs(own ?? designedShapes(design, variations), parts),
    };
  }
}

function* bakingDrawn(drawing: string, parts: PuffParts): Work<BakedPuffs> {
  return yield* bakingPuffs(yield* codeOf('billboards').makingShapes(drawing), parts);
}

/** Whether puffs are drawn as billboards, which take longer to bake than lobes. */
export function showsBillboards(values: Values): boolean {
  return formOf(values) === 'billboards' || values['style.renderer'] === 'selle';
}

function partsOf(values: Values): PuffParts {
  const isLobes = formOf(values) === 'lobes';
  return {
    caps: isLobes && !deformationOf(values).isDeformed,
    billboards: showsBillboards(values),
    precision: values['puff.precision'],
    // The renderer of Selle and lobes have the rows of one side.
    sides: formOf(values) === 'billboards' ? values['puff.views'] : 1,
  };
}

/** The shapes that values describe. */
export function designOf(values: Values): PuffDesign {
  const knobs = ['lumpiness', 'flatness', 'roughness', 'lobes', 'seed'] satisfies (keyof PuffDesign)[];
  return Object.fromEntries(knobs.map((knob) => [knob, values[`puff.${knob}`]])) as Record<keyof PuffDesign, number>;
}
