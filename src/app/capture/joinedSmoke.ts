import { MathUtils } from 'three';
import {
  ATTRIBUTE_WORDS,
  NO_END,
  PLACE_FLOATS,
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
  readonly bounds: Bounds;
}

/** Copies all puffs of an arranger to new arrays. */
export function keep(smoke: Arranger, view: View): RetainedSmoke {
  const { rows: all, bounds } = smoke.arrange(everything(view));
  const { count, place, attributes } = all;
  const rows = {
    count,
    place: place.slice(0, PLACE_FLOATS * count),
    attributes: attributes.slice(0, ATTRIBUTE_WORDS * count),
  };
  return { rows, bounds: structuredClone(bounds) };
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
    list.add(this.to.rows, (seed) => this.swelling(seed));
    return { rows: list.rows, bounds: boundsOfBoth(from.bounds, this.to.bounds), grid: undefined };
  }

  /** Scale of a puff of the second time, 0 to 1. */
  private swelling(seed: number): number {
    const begin = (1 - ONE_PUFF) * (seed / MAX_SEED);
    return MathUtils.smoothstep(this.share, begin, begin + ONE_PUFF);
  }
}

/** Rows merged from several lists. */
class RowList {
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

  /** @param scaleOf scale of a row's radius by its seed, 0 to 1 */
  add({ count, place, attributes }: Rows, scaleOf: (seed: number) => number): void {
    for (let row = 0; row < count; ++row) {
      const kind = attributes[ATTRIBUTE_WORDS * row + 1];
      const scale = scaleOf((kind >>> 8) & 0xff);
      if (scale === 0) continue;
      const [x, y, z, radius] = place.subarray(PLACE_FLOATS * row);
      const motion = attributes[ATTRIBUTE_WORDS * row];
      this.place.push(x, y, z, scale * radius);
      this.attributes.push(this.isForLight ? (motion & 0xffff) | NO_END : motion, kind);
    }
  }
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
