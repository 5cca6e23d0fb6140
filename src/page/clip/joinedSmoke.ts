import { MathUtils } from 'three';
import { loaded } from '../../renderer/extraPasses.ts';
import type { Arranger } from '../../renderer/frameInput.ts';
import type { Style } from '../../renderer/style.ts';
import type { Arranged, Bounds } from '../../simulator/arranged.ts';
import { ATTRIBUTE_BITS, ATTRIBUTE_WORDS, LAMP_FLOATS, NO_END, PLACE_FLOATS } from '../../simulator/layout.ts';
import { readBits, type Rows } from '../../simulator/rows.ts';
import type { View } from '../../simulator/view.ts';

/** Puffs dissolve one after the other, ordered by seed. Each takes this fraction of the total time. */
const ONE_PUFF = 0.4;
const MAX_SEED = 255;
/** In the numbers of a lamp. */
const [FIRST_OF_LIGHT, LUMINANCE] = [4, 7];

/** All puffs at one time, and their bounding box. */
export interface RetainedSmoke {
  readonly rows: Rows;
  /** Three floats per row: how far the puff moves in a step, metres. */
  readonly moves: Float32Array;
  readonly bounds: Bounds;
  /** Lamps at what glows, see `Simulator.glow`; undefined if nothing does. */
  readonly lamps: Float32Array | undefined;
}

/** Copies all puffs of an arranger to new arrays, and the lamps at those that glow in a style. */
export function keep(smoke: Arranger, view: View, style: Style): RetainedSmoke {
  const { rows, bounds } = smoke.arrange(everything(view));
  const { count, place, attributes } = rows;
  const colors = style.hasAdditionalLights ? loaded.additionalLights?.glowColors(style) : undefined;
  return {
    rows: {
      ...rows,
      place: place.slice(0, PLACE_FLOATS * count),
      attributes: attributes.slice(0, ATTRIBUTE_WORDS * count),
    },
    bounds: structuredClone(bounds),
    moves: smoke.moves(),
    lamps: colors && smoke.glow?.(view.blend, colors),
  };
}

/**
 * Smoke in transition between two times: the puffs of the first shrink until they disappear, those of the second grow.
 */
export class JoinedSmoke implements Arranger {
  private readonly from: Arranger;
  private readonly to: RetainedSmoke;
  private readonly share: number;
  /** The rows of the last arrange. */
  private last: readonly Row[] = [];

  /** @param share progress of the transition, 0 to 1 */
  constructor(from: Arranger, to: RetainedSmoke, share: number) {
    this.from = from;
    this.to = to;
    this.share = share;
  }

  /** Occlusion culling does not work during a transition, so all puffs are returned. */
  arrange(view: View): Arranged {
    const isForLight = view.purpose === 'light';
    const from = this.from.arrange(everything(view));
    const rows = [
      ...scaled(from.rows, (seed) => 1 - this.swelling(seed), isForLight, false),
      ...scaled(this.to.rows, (seed) => this.swelling(seed), isForLight, true),
    ];
    const isEroded = ({ words }: Row) => readBits(words, 0, ATTRIBUTE_BITS.erosion) > 0;
    const whole = rows.filter((row) => !isEroded(row));
    this.last = [...whole, ...rows.filter(isEroded)];
    return {
      rows: packed(this.last, whole.length),
      bounds: boundsOfBoth(from.bounds, this.to.bounds),
      grid: undefined,
    };
  }

  /** Each lamp moves from its place at the first time to that at the second, as its light does. */
  glow(blend: number, colors: Float32Array): Float32Array {
    const from = this.from.glow!(blend, colors);
    const to = this.to.lamps;
    if (!to) return from;
    const lamps = new Float32Array(from.length);
    for (let lamp = 0; lamp < from.length; lamp += LAMP_FLOATS) {
      const [before, after] = [from, to].map((numbers) => numbers.subarray(lamp, lamp + LAMP_FLOATS));
      const [going, coming] = [(1 - this.share) * before[LUMINANCE], this.share * after[LUMINANCE]];
      const moved = going + coming > 0 ? coming / (going + coming) : 0;
      before.forEach((number, at) => {
        lamps[lamp + at] = MathUtils.lerp(number, after[at], at < FIRST_OF_LIGHT ? moved : this.share);
      });
    }
    return lamps;
  }

  moves(): Float32Array {
    const from = this.from.moves();
    const moveOf = ({ isOfEnd, row }: Row) => (isOfEnd ? this.to.moves : from).subarray(3 * row, 3 * row + 3);
    return Float32Array.from(this.last.flatMap((row) => [...moveOf(row)]));
  }

  /** Scale of a puff of the second time, 0 to 1. */
  private swelling(seed: number): number {
    const begin = (1 - ONE_PUFF) * (seed / MAX_SEED);
    return MathUtils.smoothstep(this.share, begin, begin + ONE_PUFF);
  }
}

/**
 * Rows with scaled radii, without those that disappear.
 * @param scaleOf scale of a row's radius by its seed, 0 to 1
 * @param isOfEnd whether the rows are those of the second time, which were arranged for an eye
 */
function* scaled(
  { count, place, attributes }: Rows,
  scaleOf: (seed: number) => number,
  isForLight: boolean,
  isOfEnd: boolean,
): Generator<Row> {
  for (let row = 0; row < count; ++row) {
    const scale = scaleOf(readBits(attributes, row, ATTRIBUTE_BITS.seed));
    if (scale === 0) continue;
    const [x, y, z, radius] = place.subarray(PLACE_FLOATS * row);
    const words = attributes.slice(ATTRIBUTE_WORDS * row, ATTRIBUTE_WORDS * (row + 1));
    if (isForLight) makeCaster(words, isOfEnd);
    yield { place: [x, y, z, scale * radius], words, row, isOfEnd };
  }
}

function packed(rows: readonly Row[], whole: number): Rows {
  const place = Float32Array.from(rows.flatMap((row) => row.place));
  const attributes = Uint32Array.from(rows.flatMap((row) => [...row.words]));
  return { count: rows.length, whole, place, attributes };
}

interface Row {
  readonly place: readonly number[];
  readonly words: Uint32Array;
  /** Its number in the list that it comes from. */
  readonly row: number;
  readonly isOfEnd: boolean;
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
