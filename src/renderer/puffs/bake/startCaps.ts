/**
 * Start caps of shadow volumes: a puff's volume starts behind all of its lit points, so that a puff never shadows its
 * own lit pixels. The caps are tabulated by light direction, because lobes make them discontinuous. They depend on the
 * threshold between shade and light in the ramp, and are rebaked when it changes.
 *
 * Lookups use the nearest entry. An entry bounds all directions of its cell, not only the central one: a point counts
 * if it is lit from any direction in the cell, with its largest distance over the cell.
 */
import { POINT_STRIDE, type Patch } from './patches.ts';
import { type Vector, lengthOf } from '../vector.ts';
import { finished, type Work } from '../../../base/work.ts';
import { CAP_COLUMNS, CAP_ROWS } from '../../../base/constants.ts';

/** Entries along each side of a block that shares one patch selection. Divides CAP_COLUMNS and CAP_ROWS. */
const BLOCK = 8;

/**
 * Start caps of all variations. `values[(layer * height + row) * width + column]` is the largest -(p . L) over the
 * surface points p of a puff with N . L above the threshold: the distance of the farthest lit point behind the centre
 * plane perpendicular to L, in particle radii. L is the direction towards the light in the puff's local space, with
 * column = floor((atan2(L.y, L.x) / 2 pi + 1/2) * width), row = floor(acos(L.z) / pi * height).
 */
export interface StartCaps {
  readonly width: number;
  readonly height: number;
  readonly count: number;
  readonly values: Float32Array;
}

/**
 * Bakes the tables of all variations.
 * @param surfaces the visible points of each variation
 * @param litThreshold N . L from which a pixel's lit colour differs from its unlit one, -1..1
 */
export function bakeStartCaps(surfaces: readonly (readonly Patch[])[], litThreshold: number): StartCaps {
  return joined(surfaces.map((patches) => bakeTable(patches, litThreshold)));
}

/** Concatenates the tables of single variations. */
export function joined(tables: readonly Float32Array[]): StartCaps {
  const entries = CAP_COLUMNS * CAP_ROWS;
  const values = new Float32Array(entries * tables.length);
  tables.forEach((table, layer) => values.set(table, entries * layer));
  return { width: CAP_COLUMNS, height: CAP_ROWS, count: tables.length, values };
}

/** Bakes the table of one variation. */
export function bakeTable(patches: readonly Patch[], litThreshold: number): Float32Array {
  return finished(bakingTable(patches, litThreshold));
}

/** As {@link bakeTable}, in slices of about a millisecond. */
export function* bakingTable(patches: readonly Patch[], litThreshold: number): Work<Float32Array> {
  const table = new Float32Array(CAP_COLUMNS * CAP_ROWS);
  const bounds = new PatchBounds(patches, Math.acos(litThreshold));
  for (let row = 0; row < CAP_ROWS; row += BLOCK) {
    for (let column = 0; column < CAP_COLUMNS; column += BLOCK) {
      yield* bakingBlock(bounds, row, column, table);
    }
  }
  return table;
}

/** The start cap of a layer for a unit direction towards the light, with the same lookup as the shader. */
export function startCapAt({ width, height, values }: StartCaps, layer: number, [x, y, z]: Vector): number {
  const column = Math.floor((Math.atan2(y, x) / (2 * Math.PI) + 0.5) * width);
  const row = Math.floor((Math.acos(Math.min(1, Math.max(-1, z))) / Math.PI) * height);
  return values[(layer * height + Math.min(row, height - 1)) * width + Math.min(column, width - 1)];
}

/**
 * A cap that is valid for every ramp and light direction: no point with N . L > 0 is farther behind, in particle radii.
 * A point is farthest behind the centre at grazing light, or when the light comes from the opposite side of the centre.
 */
export function latestCap(patches: readonly Patch[]): number {
  let latest = 0;
  for (const { points } of patches) {
    for (let i = 0; i < points.length; i += POINT_STRIDE) {
      const outward = points[i] * points[i + 3] + points[i + 1] * points[i + 4] + points[i + 2] * points[i + 5];
      const length = points[i + 6];
      latest = Math.max(latest, outward < 0 ? length : Math.sqrt(Math.max(0, length * length - outward * outward)));
    }
  }
  return latest;
}

/** A cone that bounds the directions of `count` by `count` entries, starting at this one. */
function cellAt(row: number, column: number, count: number): Cell {
  const halfRow = (Math.PI / CAP_ROWS / 2) * count;
  const halfColumn = (Math.PI / CAP_COLUMNS) * count;
  const polar = (row / CAP_ROWS) * Math.PI + halfRow;
  const azimuth = (column / CAP_COLUMNS - 0.5) * 2 * Math.PI + halfColumn;
  const angleTo = (corner: number): number =>
    Math.acos(Math.cos(polar) * Math.cos(corner) + Math.sin(polar) * Math.sin(corner) * Math.cos(halfColumn));
  const spread = Math.max(angleTo(polar - halfRow), angleTo(polar + halfRow));
  const across = Math.sin(polar);
  const [x, y, z] = [across * Math.cos(azimuth), across * Math.sin(azimuth), Math.cos(polar)];
  return { x, y, z, spread, cosine: Math.cos(spread), sine: Math.sin(spread) };
}

/** Fills a block of entries: selects patches for the whole block, then evaluates each entry. */
function* bakingBlock(bounds: PatchBounds, row: number, column: number, table: Float32Array): Work<void> {
  bounds.choose(cellAt(row, column, BLOCK));
  for (let j = row; j < row + BLOCK; j++) {
    for (let i = column; i < column + BLOCK; i++) table[j * CAP_COLUMNS + i] = bounds.farthestFrom(cellAt(j, i, 1));
    if (j % (BLOCK / 2) === 0) yield;
  }
}

/** Finds the lit surface point farthest behind the centre. Bounds on patches skip most of the points. */

/** Result for light directions with no lit visible point. */
export const NOTHING_LIT = -1;

/** A cone of directions around a central one, which bounds a table entry or a block of entries. */
interface Cell {
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
class PatchBounds {
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
