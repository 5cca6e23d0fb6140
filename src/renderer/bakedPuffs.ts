import type { BakedPuffs } from './gpu/puffTextures.ts';
import { FIRST_BORDER } from './gpu/ramps.ts';
import { bakingLobes } from './puffs/bake/bakeLobes.ts';
import type { Precision } from './puffs/billboards/layers.ts';
import { LruCache } from './puffs/lru.ts';
import { LOBE_SHAPES } from './puffs/lobeShapes.ts';
import { keyOf, type PuffShape } from './puffs/shapes.ts';
import { finished, type Work } from '../base/work.ts';
import { codeOf, loaded } from './extraPasses.ts';

/** Baked puffs by shape. Smokes with the same object share their textures on a device. */
const cache = new LruCache<BakedPuffs>(8);
/** Work in progress by what it bakes. Concurrent requests for the same share it. */
const begun = new Map<string, Work<unknown>>();

/** Parts of puffs that are otherwise baked synchronously on first access. */
export interface PuffParts {
  /** Start caps, which lobe puffs need unless they turn, stretch or unfold, if their code is loaded. */
  readonly caps?: boolean;
  /** Billboards, if their code is loaded. */
  readonly billboards?: boolean;
  /** Of the layers of billboards. */
  readonly precision?: Precision;
  /** Sides of each variation of billboards, 1, 2, 4 or 8. */
  readonly sides?: number;
}

/** Bakes puffs like {@link bakingPuffs}, but synchronously. Defaults to the built-in shapes. */
export function bakedPuffs(shapes: readonly PuffShape[] = LOBE_SHAPES): BakedPuffs {
  return finished(bakingPuffs(shapes));
}

/**
 * Bakes lobe puffs in steps of about a millisecond, and then billboards in steps of a few milliseconds.
 * @param shapes one for each variation
 */
export function* bakingPuffs(shapes: readonly PuffShape[], parts: PuffParts = {}): Work<BakedPuffs> {
  const { precision = 16, sides = 1 } = parts;
  const key = `${precision} ${sides} ${keyOf(shapes)}`;
  yield* sharing(key, () => cache.making(key, () => bakingNew(shapes, precision, sides)));
  const puffs = cache.get(key)!;
  const { caps, billboards } = loaded;
  if (parts.caps && caps) yield* sharing(`caps ${key}`, () => caps.bakingCaps(shapes, FIRST_BORDER));
  if (parts.billboards) yield* billboards?.bakingBillboards(shapes, precision, sides) ?? [];
  return puffs;
}

/** Advances work together with other requests for it. The result must be in a cache, so that it can begin again. */
function* sharing(key: string, begin: () => Work<unknown>): Work<void> {
  for (;;) {
    const work = begun.get(key) ?? begin();
    begun.delete(key);
    if (work.next().done) return;
    begun.set(key, work);
    yield;
  }
}

/** The code of start caps and of billboards must be loaded when they are read, see `fetchExtras`. */
function* bakingNew(shapes: readonly PuffShape[], precision: Precision, sides: number): Work<BakedPuffs> {
  const lobes = yield* bakingLobes(shapes);
  let caps: BakedPuffs['lobes']['caps'] | undefined;
  let billboards: BakedPuffs['billboards'] | undefined;
  return {
    lobes: {
      ...lobes,
      get caps() {
        caps ??= finished(codeOf('caps').bakingCaps(shapes, FIRST_BORDER));
        return caps;
      },
    },
    get billboards() {
      billboards ??= finished(codeOf('billboards').bakingBillboards(shapes, precision, sides));
      return billboards;
    },
  };
}
