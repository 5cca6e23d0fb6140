import { MathUtils } from 'three';
import {
  ATTRIBUTE_BITS,
  ATTRIBUTE_WORDS,
  NO_END,
  PLACE_FLOATS,
  readBits,
  type Arranged,
  type Arranger,
  type Bounds,
  type Rows,
  type View,
} from '../../internal.ts';

/** Puffs dissolve one after the other, ordered by seed. Each takes this fraction of the total time. */
const ONE_PUFF = 0.4;
const MAX_SEED = 255;

/** All puffs at one time, and their bounding box. */
export interface RetainedSmoke {
  readonly rows: Rows;
  /** Three floats per row: how far the puff moves in a step, metres. */
  readonly moves: Float32Array;
  readonly bounds: Bounds;
}

/** Copies all puffs of an arranger to new arrays. */
export function keep(smoke: Arranger, view: View): RetainedSmoke {
  const { rows, bounds } = smoke.arrange(everything(view));
  const { count, place, attributes } = rows;
  return {
    rows: {
      ...rows,
      place: place.slice(0, PLACE_FLOATS * count),
      attributes: attributes.slice(0, ATTRIBUTE_WORDS * count),
    },
    bounds: structuredClone(bounds),
    moves: smoke.moves(),
  };
}

/**
 * Smoke in transition between two times: the puffs of the first shrink until they disappear, those of the second grow.
 */
export class JoinedSmoke implements Arranger {
  private readonly from: Arranger;
  private readonly to: RetainedSmoke;
  private readonly share: number;
  private lastMoves = new Float32Array();

  /** @param share progress of the transition, 0 to 1 */
  constructor(from: Arranger, to: RetainedSmoke, share: number) {
    this.from = from;
    this.to = to;
    this.share = share;
  }

  /** Occlusion culling does not work during a transition, so all puffs are returned. */
  arrange(view: View): Arranged {
    const list = new RowList(view.purpose === 'light');
    const from = this.from.arrange(everything(view));
    list.add(from.rows, this.from.moves(), (seed) => 1 - this.swelling(seed));
    list.add(this.to.rows, this.to.moves, (seed) => this.swelling(seed), true);
    const { rows, moves } = list.arrays();
    this.lastMoves = moves;
    return { rows, bounds: boundsOfBoth(from.bounds, this.to.bounds), grid: undefined };
  }

  moves(): Float32Array {
    return this.lastMoves;
  }

  /** Scale of a puff of the second time, 0 to 1. */
  private swelling(seed: number): number {
    const begin = (1 - ONE_PUFF) * (seed / MAX_SEED);
    return MathUtils.smoothstep(this.share, begin, begin + ONE_PUFF);
  }
}

/** Rows merged from several lists. */
class RowList {
  private readonly whole: Row[] = [];
  private readonly eroded: Row[] = [];
  private readonly isForLight: boolean;

  constructor(isForLight: boolean) {
    this.isForLight = isForLight;
  }

  arrays(): { rows: Rows; moves: Float32Array<ArrayBuffer> } {
    const all = [...this.whole, ...this.eroded];
    const place = Float32Array.from(all.flatMap((row) => row.place));
    const attributes = Uint32Array.from(all.flatMap((row) => [...row.words]));
    const rows = { count: all.length, whole: this.whole.length, place, attributes };
    return { rows, moves: Float32Array.from(all.flatMap((row) => [...row.move])) };
  }

  /**
   * @param scaleOf scale of a row's radius by its seed, 0 to 1
   * @param isOfEye whether the rows were arranged for an eye, whatever this list is for
   */
  add(
    { count, place, attributes }: Rows,
    moves: Float32Array,
    scaleOf: (seed: number) => number,
    isOfEye = false,
  ): void {
    const { seed, erosion } = ATTRIBUTE_BITS;
    for (let row = 0; row < count; ++row) {
      const scale = scaleOf(readBits(attributes, row, seed));
      if (scale === 0) continue;
      const [x, y, z, radius] = place.subarray(PLACE_FLOATS * row);
      const words = attributes.slice(ATTRIBUTE_WORDS * row, ATTRIBUTE_WORDS * (row + 1));
      if (this.isForLight) makeCaster(words, isOfEye);
      const list = readBits(words, 0, erosion) > 0 ? this.eroded : this.whole;
      list.push({ place: [x, y, z, scale * radius], words, move: moves.subarray(3 * row, 3 * row + 3) });
    }
  }
}

interface Row {
  readonly place: readonly number[];
  readonly words: Uint32Array;
  readonly move: Float32Array;
}

/** Changes attributes to those of a caster with an unbounded shadow: its age replaces temperature and tint. */
function makeCaster(words: Uint32Array, isOfEye: boolean): void {
  const { age, casterAge } = ATTRIBUTE_BITS;
  if (isOfEye) {
    words[casterAge.word] = (words[casterAge.word] & ~NO_END) | (readBits(words, 0, age) << casterAge.shift);
  }
  words[age.word] |= NO_END;
}

function boundsOfBoth(a: Bounds, b: Bounds): Bounds {
  const both = (choose: (...numbers: number[]) => number, side: 'min' | 'max'): Bounds['min'] => {
    const [x, y, z] = a[side].map((value, axis) => choose(value, b[side][axis]));
    return [x, y, z];
  };
  return {
    min: both(Math.min, 'min'),
    max: both(Math.max, 'max'),
    greatestRadius: Math.max(a.greatestRadius, b.greatestRadius),
  };
}

function everything(view: View): View {
  return { ...view, cull: false, coverage: undefined };
}
