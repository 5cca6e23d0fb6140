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

/** Puffs at one time. */
export interface MovingRows {
  readonly rows: Rows;
  /** Three floats per row: how far the puff moves in a step, metres. */
  readonly moves: Float32Array;
}

/** All puffs at one time, and their bounding box. */
export interface RetainedSmoke extends MovingRows {
  readonly bounds: Bounds;
}

/** Copies all puffs of an arranger to new arrays. */
export function keep(smoke: Arranger, view: View): RetainedSmoke {
  const arranged = smoke.arrange(everything(view));
  // The next arrange overwrites both.
  const [rows, bounds] = [copied(arranged.rows), structuredClone(arranged.bounds)];
  return { rows, bounds, moves: movesOf(smoke, view, rows) };
}

/** Finds each puff at the start and at the end of the latest step. */
function movesOf(smoke: Arranger, view: View, rows: Rows): Float32Array {
  const end = new PuffFinder(copied(smoke.arrange({ ...everything(view), blend: 1 }).rows));
  const start = new PuffFinder(smoke.arrange({ ...everything(view), blend: 0 }).rows);
  const moves = new Float32Array(3 * rows.count);
  for (let row = 0; row < rows.count; ++row) {
    const [from, to] = [start.nearest(rows, row), end.nearest(rows, row)];
    if (from && to) from.forEach((coordinate, axis) => (moves[3 * row + axis] = to[axis] - coordinate));
  }
  return moves;
}

function copied({ count, place, attributes }: Rows): Rows {
  return {
    count,
    place: place.slice(0, PLACE_FLOATS * count),
    attributes: attributes.slice(0, ATTRIBUTE_WORDS * count),
  };
}

/** Farthest movement of a puff in a step, in radii. A puff that moves farther is treated as new. */
const FARTHEST = 4;

/** Finds puffs again at another time: rows have no number, but a puff keeps its seed, variation and tint. */
class PuffFinder {
  private readonly rows: Rows;
  private readonly byKind = new Map<number, number[]>();

  constructor(rows: Rows) {
    this.rows = rows;
    for (let row = 0; row < rows.count; ++row) {
      const kind = kindOf(rows, row);
      const others = this.byKind.get(kind);
      if (others) others.push(row);
      else this.byKind.set(kind, [row]);
    }
  }

  /** @returns the nearest place of a puff like the one of a row, or undefined if none is close enough */
  nearest(rows: Rows, row: number): Float32Array | undefined {
    const [x, y, z, radius] = rows.place.subarray(PLACE_FLOATS * row);
    let [found, distance]: [Float32Array | undefined, number] = [undefined, FARTHEST * radius];
    for (const other of this.byKind.get(kindOf(rows, row)) ?? []) {
      const place = this.rows.place.subarray(PLACE_FLOATS * other, PLACE_FLOATS * other + 3);
      const away = Math.hypot(place[0] - x, place[1] - y, place[2] - z);
      if (away <= distance) [found, distance] = [place, away];
    }
    return found;
  }
}

function kindOf({ attributes }: Rows, row: number): number {
  const { seed, variation, tint } = ATTRIBUTE_BITS;
  const [a, b, c] = [seed, variation, tint].map((bits) => readBits(attributes, row, bits));
  return (a * 256 + b) * 256 + c;
}

/**
 * Smoke in transition between two times: the puffs of the first shrink until they disappear, those of the second grow.
 */
export class JoinedSmoke implements Arranger {
  private readonly from: Arranger;
  private readonly to: RetainedSmoke;
  private readonly share: number;

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
    list.add(from.rows, (seed) => 1 - this.swelling(seed));
    list.add(this.to.rows, (seed) => this.swelling(seed), { isOfEye: true });
    return { rows: list.rows, bounds: boundsOfBoth(from.bounds, this.to.bounds), grid: undefined };
  }

  /** All puffs of an eye's view, and their moves. */
  moving(view: View): MovingRows {
    const list = new RowList(false);
    const from = keep(this.from, view);
    list.add(from.rows, (seed) => 1 - this.swelling(seed), { moves: from.moves });
    list.add(this.to.rows, (seed) => this.swelling(seed), { moves: this.to.moves });
    return { rows: list.rows, moves: Float32Array.from(list.moves) };
  }

  /** Scale of a puff of the second time, 0 to 1. */
  private swelling(seed: number): number {
    const begin = (1 - ONE_PUFF) * (seed / MAX_SEED);
    return MathUtils.smoothstep(this.share, begin, begin + ONE_PUFF);
  }
}

/** Rows merged from several lists. */
class RowList {
  readonly moves: number[] = [];
  private readonly place: number[] = [];
  private readonly attributes: number[] = [];
  private readonly isForLight: boolean;

  constructor(isForLight: boolean) {
    this.isForLight = isForLight;
  }

  get rows(): Rows {
    const { place, attributes } = this;
    return {
      count: attributes.length / ATTRIBUTE_WORDS,
      place: Float32Array.from(place),
      attributes: Uint32Array.from(attributes),
    };
  }

  /**
   * @param scaleOf scale of a row's radius by its seed, 0 to 1
   * @param isOfEye whether the rows were arranged for an eye, whatever this list is for
   */
  add(
    { count, place, attributes }: Rows,
    scaleOf: (seed: number) => number,
    { moves, isOfEye = false }: { moves?: Float32Array; isOfEye?: boolean } = {},
  ): void {
    for (let row = 0; row < count; ++row) {
      const scale = scaleOf(readBits(attributes, row, ATTRIBUTE_BITS.seed));
      if (scale === 0) continue;
      const [x, y, z, radius] = place.subarray(PLACE_FLOATS * row);
      const words = attributes.slice(ATTRIBUTE_WORDS * row, ATTRIBUTE_WORDS * (row + 1));
      if (this.isForLight) makeCaster(words, isOfEye);
      this.place.push(x, y, z, scale * radius);
      this.attributes.push(...words);
      if (moves) this.moves.push(...moves.subarray(3 * row, 3 * row + 3));
    }
  }
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
