/**
 * Exact Euclidean distance transform on a square grid in linear time, after Felzenszwalb and Huttenlocher, 'Distance
 * Transforms of Sampled Functions' (Theory of Computing 8, 2012). Each row takes the lower envelope of parabolas rooted
 * at the column distances. The set is binary, so two scans find the column distances without an envelope.
 */

import { finished, type Work } from '../../../base/work.ts';

/** Rows of 512 cells in a slice of about two milliseconds. */
const ROWS_A_SLICE = 24;

/** The nearest cell of a set, for each cell of a grid. */
export interface NearestCells {
  /** Index of the nearest cell of the set; -1 if the set is empty. */
  readonly nearest: Int32Array;
  /** Squared distance between cell centres, in cells; Infinity if the set is empty. */
  readonly squaredDistance: Float32Array;
}

/** Finds the nearest cell with `inSet[cell] === value` for each cell of a `size` by `size` grid (size <= 4096). */
export function nearestCells(inSet: Uint8Array, value: 0 | 1, size: number): NearestCells {
  return finished(findingNearest(inSet, value, size));
}

/** As {@link nearestCells}, in slices of a few milliseconds. */
export function* findingNearest(inSet: Uint8Array, value: 0 | 1, size: number): Work<NearestCells> {
  const nearest = yield* findingInColumns(inSet, value, size);
  yield;
  const squaredDistance = new Float32Array(size * size);
  const envelope = new Envelope(size);
  for (let y = 0; y < size; y++) {
    envelope.sweepRow(y, nearest, squaredDistance);
    if (y % ROWS_A_SLICE === ROWS_A_SLICE - 1) yield;
  }
  yield;
  return { nearest, squaredDistance };
}

/** The nearest cell of the set in the same column, or -1. */
function* findingInColumns(inSet: Uint8Array, value: 0 | 1, size: number): Work<Int32Array> {
  const nearest = new Int32Array(size * size);
  for (let cell = 0; cell < nearest.length; cell++) {
    if (inSet[cell] === value) nearest[cell] = cell;
    else nearest[cell] = cell < size ? -1 : nearest[cell - size];
  }
  yield;
  for (let cell = nearest.length - size - 1; cell >= 0; cell--) {
    const above = nearest[cell + size];
    if (above >= 0 && (nearest[cell] < 0 || above - cell < cell - nearest[cell])) nearest[cell] = above;
  }
  return nearest;
}

/** Computes the lower envelope of the parabolas of one row, with reusable buffers. */
class Envelope {
  private readonly size: number;
  private readonly height: Float64Array;
  private readonly source: Int32Array;
  private readonly apex: Int32Array;
  private readonly start: Float64Array;

  constructor(size: number) {
    this.size = size;
    this.height = new Float64Array(size);
    this.source = new Int32Array(size);
    this.apex = new Int32Array(size);
    this.start = new Float64Array(size);
  }

  /** Replaces the nearest cells per column by the nearest cells overall, and writes their squared distances. */
  sweepRow(y: number, nearest: Int32Array, squaredDistance: Float32Array): void {
    const first = y * this.size;
    for (let x = 0; x < this.size; x++) {
      const source = nearest[first + x];
      const rows = (source - first - x) / this.size;
      this.source[x] = source;
      this.height[x] = source < 0 ? Infinity : rows * rows;
    }
    const parabolas = this.build();
    for (let x = 0, k = 0; x < this.size; x++) {
      while (k + 1 < parabolas && this.start[k + 1] < x) k++;
      const apex = this.apex[k];
      nearest[first + x] = parabolas > 0 ? this.source[apex] : -1;
      squaredDistance[first + x] = parabolas > 0 ? (x - apex) * (x - apex) + this.height[apex] : Infinity;
    }
  }

  /** Fills `apex` and `start` from left to right. Returns the number of parabolas of the envelope. */
  private build(): number {
    let count = 0;
    for (let x = 0; x < this.size; x++) {
      if (this.height[x] === Infinity) continue;
      let from = -Infinity;
      while (count > 0) {
        from = this.crossing(this.apex[count - 1], x);
        if (from > this.start[count - 1]) break;
        count--;
      }
      this.apex[count] = x;
      this.start[count] = count === 0 ? -Infinity : from;
      count++;
    }
    return count;
  }

  /** The x from which the parabola with apex `right` is below the one with apex `left`. */
  private crossing(left: number, right: number): number {
    const rise = this.height[right] - this.height[left];
    return (rise + right * right - left * left) / (2 * (right - left));
  }
}

/**
 * Signed distance from cell centres to the border of the covered region, in cells: negative inside, positive outside.
 * The border is assumed half a cell from the last covered centre, so the error is below half a cell. A fully covered
 * grid gives -Infinity, an empty one Infinity.
 */
export function signedDistance(coverage: Uint8Array, size: number): Float32Array {
  return finished(measuringDistance(coverage, size));
}

/** As {@link signedDistance}, in slices of a few milliseconds. */
export function* measuringDistance(coverage: Uint8Array, size: number): Work<Float32Array> {
  const toInside = (yield* findingNearest(coverage, 1, size)).squaredDistance;
  const toOutside = (yield* findingNearest(coverage, 0, size)).squaredDistance;
  const signed = new Float32Array(size * size);
  for (let cell = 0; cell < signed.length; cell++) {
    signed[cell] = coverage[cell] === 1 ? 0.5 - Math.sqrt(toOutside[cell]) : Math.sqrt(toInside[cell]) - 0.5;
  }
  return signed;
}
