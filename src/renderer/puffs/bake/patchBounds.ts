/** Finds the lit surface point farthest behind the centre. Bounds on patches skip most of the points. */
import { POINT_STRIDE, type Patch } from './patches.ts';
import { lengthOf } from '../vector.ts';

/** Result for light directions with no lit visible point. */
export const NOTHING_LIT = -1;

/** A cone of directions around a central one, which bounds a table entry or a block of entries. */
export interface Cell {
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly spread: number;
  /** Cosine and sine of `spread`, the half-angle of the cone in radians. */
  readonly cosine: number;
  readonly sine: number;
}

/**
 * Numbers per patch: normal, cosine and sine of the angle to L beyond which the whole patch is unlit, centre, length of
 * the centre, radius.
 */
const BOUND_STRIDE = 10;

/** Patches with their bounds in flat arrays, because baking spends most of its time here. */
export class PatchBounds {
  private readonly patches: readonly Patch[];
  /** Largest angle between normal and light at which a point is lit, in radians. */
  private readonly limit: number;
  private readonly bounds: Float64Array;
  /** Selected patches, sorted by descending `reaches`: the bound on the distance behind the centre of each patch. */
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

  /** Selects the patches that can be lit from a cell. */
  choose(cell: Cell): void {
    this.chosen = [];
    for (let patch = 0; patch < this.patches.length; patch++) {
      if (!this.canBeLit(patch, cell)) continue;
      this.reaches[patch] = this.reachOf(patch, cell);
      this.chosen.push(patch);
    }
    this.chosen.sort((a, b) => this.reaches[b] - this.reaches[a]);
  }

  /** Distance behind the centre of the farthest point in the selected patches that can be lit from a cell. */
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
    // If the angles add up to more than pi, every direction qualifies.
    return bounds[at + 3] <= -cosine || bounds[at] * x + bounds[at + 1] * y + bounds[at + 2] * z > faintest;
  }

  /** Upper bound on -(p . L) over a patch and a cell. */
  private reachOf(patch: number, { x, y, z, cosine, sine }: Cell): number {
    const { bounds } = this;
    const at = BOUND_STRIDE * patch;
    const behind = -(bounds[at + 5] * x + bounds[at + 6] * y + bounds[at + 7] * z);
    return maxBehind(behind, bounds[at + 8], cosine, sine) + bounds[at + 9];
  }
}

/** Largest -(p . L) over the points that are lit from any direction in the cell, or `atLeast` if that is larger. */
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

/**
 * Largest distance behind the centre over all directions of a cell, for a point at distance `length` from the centre
 * that is `behind` it for the central direction.
 */
function maxBehind(behind: number, length: number, cosine: number, sine: number): number {
  if (behind >= length * cosine) return length;
  return behind * cosine + Math.sqrt(Math.max(0, length * length - behind * behind)) * sine;
}
