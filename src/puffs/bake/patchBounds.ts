/** Which point of a surface is lit and lies farthest behind: asked of few patches, by what bounds them. */
import { POINT_STRIDE, type Patch } from './patches.ts';
import { lengthOf } from '../vector.ts';

/** The answer for directions from which no visible point is lit. */
export const NOTHING_LIT = -1;

/** Directions within an angle, the spread, of the middle: those that share an entry, or a block of them. */
export interface Cell {
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly spread: number;
  /** Cosine and sine of the spread. */
  readonly cosine: number;
  readonly sine: number;
}

/** Numbers a patch: normal, cosine and sine of the angle to L at which all of it is dark, centre, its length, radius. */
const BOUND_STRIDE = 10;

/** Patches with what rules them out quickly, in flat arrays: this is where baking spends its time. */
export class PatchBounds {
  private readonly patches: readonly Patch[];
  /** The largest angle between normal and light at which a point is lit. */
  private readonly limit: number;
  private readonly bounds: Float64Array;
  /** The chosen patches, those first that can reach farthest behind, and how far that is for each patch. */
  private chosen: number[] = [];
  private readonly reaches: Float64Array;

  constructor(patches: readonly Patch[], limit: number) {
    this.patches = patches;
    this.limit = limit;
    this.reaches = new Float64Array(patches.length);
    this.bounds = new Float64Array(BOUND_STRIDE * patches.length);
    patches.forEach(({ normal, normalSpread, center, radius }, patch) => {
      const dark = Math.min(Math.PI, limit + normalSpread);
      const row = [...normal, Math.cos(dark), Math.sin(dark), ...center, lengthOf(center), radius];
      this.bounds.set(row, BOUND_STRIDE * patch);
    });
  }

  /** Chooses the patches that can be lit from a cell. */
  choose(cell: Cell): void {
    this.chosen = [];
    for (let patch = 0; patch < this.patches.length; patch++) {
      if (!this.canBeLit(patch, cell)) continue;
      this.reaches[patch] = this.reachOf(patch, cell);
      this.chosen.push(patch);
    }
    this.chosen.sort((a, b) => this.reaches[b] - this.reaches[a]);
  }

  /** How far behind the farthest point lies that can be lit from a cell; only chosen patches count. */
  farthestFrom(cell: Cell): number {
    const faintest = Math.cos(Math.min(Math.PI, this.limit + cell.spread));
    let farthest = NOTHING_LIT;
    for (const patch of this.chosen) {
      if (this.reaches[patch] <= farthest) break;
      if (!this.canBeLit(patch, cell) || this.reachOf(patch, cell) <= farthest) continue;
      farthest = farthestPoint(this.patches[patch].points, faintest, cell, farthest);
    }
    return farthest;
  }

  private canBeLit(patch: number, { x, y, z, cosine, sine }: Cell): boolean {
    const { bounds } = this;
    const at = BOUND_STRIDE * patch;
    const faintest = bounds[at + 3] * cosine - bounds[at + 4] * sine;
    // Beyond half a turn the sum of the angles takes in every direction.
    return bounds[at + 3] <= -cosine || bounds[at] * x + bounds[at + 1] * y + bounds[at + 2] * z > faintest;
  }

  /** Bound on -(p . L) over a patch and a cell. */
  private reachOf(patch: number, { x, y, z, cosine, sine }: Cell): number {
    const { bounds } = this;
    const at = BOUND_STRIDE * patch;
    const behind = -(bounds[at + 5] * x + bounds[at + 6] * y + bounds[at + 7] * z);
    return maxBehind(behind, bounds[at + 8], cosine, sine) + bounds[at + 9];
  }
}

/** Largest -(p . L) over the points that are lit from somewhere in the cell, but not less than `atLeast`. */
function farthestPoint(points: Float32Array, faintest: number, cell: Cell, atLeast: number): number {
  const { x, y, z, cosine, sine } = cell;
  let farthest = atLeast;
  for (let i = 0; i < points.length; i += POINT_STRIDE) {
    if (points[i] * x + points[i + 1] * y + points[i + 2] * z <= faintest) continue;
    const behind = -(points[i + 3] * x + points[i + 4] * y + points[i + 5] * z);
    if (behind * cosine + points[i + 6] * sine <= farthest) continue;
    farthest = Math.max(farthest, maxBehind(behind, points[i + 6], cosine, sine));
  }
  return farthest;
}

/** The most that a point at `length` from the centre, `behind` it for the cell's middle, is behind it in the cell. */
function maxBehind(behind: number, length: number, cosine: number, sine: number): number {
  if (behind >= length * cosine) return length;
  return behind * cosine + Math.sqrt(Math.max(0, length * length - behind * behind)) * sine;
}
