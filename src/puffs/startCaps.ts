/**
 * Where a puff's shadow volume may begin: behind every point of the puff that is still lit, so that a lone puff never
 * masks its own lit pixels, whatever its lobes do. Tabulated over the directions towards the light, because lobes make
 * it jump; it depends on where the ramp turns from shade to light and is baked anew when that moves.
 *
 * The table is read at the nearest entry. An entry bounds all directions of its cell, not only the one in its middle:
 * a point counts if it can be lit from anywhere in the cell, with the largest distance it can have from there.
 */
import { POINT_STRIDE, type Patch } from './patches.ts';
import { dot, lengthOf, type Vector } from './vector.ts';

/** Columns of a table: azimuth of the light about the view axis. */
export const CAP_COLUMNS = 64;
/** Rows of a table: angle between light and view axis. */
export const CAP_ROWS = 32;
/** The entry of directions from which no visible point is lit: there a volume may begin anywhere. */
export const NOTHING_LIT = -1;

/**
 * Start caps of all variations. `values[(layer * height + row) * width + column]` is the largest -(p . L) over the
 * points p of a puff's surface with N . L above the threshold: how far behind the centre plane across L the farthest lit
 * point lies, in particle radii. For the direction L towards the light in the puff's own frame,
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
 * @param surfaces the points of each variation that may be seen
 * @param litThreshold N . L from which a pixel's lit colour differs from its unlit one, -1..1
 */
export function bakeStartCaps(surfaces: readonly (readonly Patch[])[], litThreshold: number): StartCaps {
  const entries = CAP_COLUMNS * CAP_ROWS;
  const values = new Float32Array(entries * surfaces.length);
  surfaces.forEach((patches, layer) => {
    for (let row = 0; row < CAP_ROWS; row++) {
      const first = layer * entries + row * CAP_COLUMNS;
      bakeRow(patches, Math.acos(litThreshold), row, values.subarray(first, first + CAP_COLUMNS));
    }
  });
  return { width: CAP_COLUMNS, height: CAP_ROWS, count: surfaces.length, values };
}

/** The start cap of a layer for a unit direction towards the light, as the shader reads it. */
export function startCapAt({ width, height, values }: StartCaps, layer: number, [x, y, z]: Vector): number {
  const column = Math.floor((Math.atan2(y, x) / (2 * Math.PI) + 0.5) * width);
  const row = Math.floor((Math.acos(Math.min(1, Math.max(-1, z))) / Math.PI) * height);
  return values[(layer * height + Math.min(row, height - 1)) * width + Math.min(column, width - 1)];
}

/** The directions that share an entry: those within an angle, the spread, of the middle. */
interface Cell {
  readonly middle: Vector;
  /** Cosine and sine of the spread. */
  readonly cosine: number;
  readonly sine: number;
}

/** Fills one row of a table. `limit`: the largest angle between normal and light at which a point is lit. */
function bakeRow(patches: readonly Patch[], limit: number, row: number, entries: Float32Array): void {
  const polar = ((row + 0.5) / CAP_ROWS) * Math.PI;
  const spread = cellSpread(polar);
  const faintest = Math.cos(Math.min(Math.PI, limit + spread));
  const faintestOf = patches.map(({ normalSpread }) => Math.cos(Math.min(Math.PI, limit + spread + normalSpread)));
  let last = 0;
  for (let column = 0; column < CAP_COLUMNS; column++) {
    const azimuth = ((column + 0.5) / CAP_COLUMNS - 0.5) * 2 * Math.PI;
    const middle: Vector = [Math.sin(polar) * Math.cos(azimuth), Math.sin(polar) * Math.sin(azimuth), Math.cos(polar)];
    const cell = { middle, cosine: Math.cos(spread), sine: Math.sin(spread) };
    // The patch that decided the neighbouring cell comes first: it rules out most of the others.
    let farthest = farthestPoint(patches[last].points, faintest, cell, NOTHING_LIT);
    for (let i = 0; i < patches.length; i++) {
      if (dot(patches[i].normal, middle) <= faintestOf[i] || reachBehind(patches[i], cell) <= farthest) continue;
      const candidate = farthestPoint(patches[i].points, faintest, cell, farthest);
      if (candidate > farthest) [farthest, last] = [candidate, i];
    }
    entries[column] = farthest;
  }
}

/** Angle between the middle of a cell and its farthest corner. */
function cellSpread(polar: number): number {
  const halfRow = Math.PI / CAP_ROWS / 2;
  const cosine = Math.cos(Math.PI / CAP_COLUMNS);
  const angleTo = (corner: number): number =>
    Math.acos(Math.cos(polar) * Math.cos(corner) + Math.sin(polar) * Math.sin(corner) * cosine);
  return Math.max(angleTo(polar - halfRow), angleTo(polar + halfRow));
}

/** Bound on -(p . L) over a patch and a cell. */
function reachBehind({ center, radius }: Patch, cell: Cell): number {
  return mostBehind(-dot(center, cell.middle), lengthOf(center), cell) + radius;
}

/** Largest -(p . L) over the points that are lit from somewhere in the cell, but not less than `atLeast`. */
function farthestPoint(points: Float32Array, faintest: number, cell: Cell, atLeast: number): number {
  const [x, y, z] = cell.middle;
  const { cosine, sine } = cell;
  let farthest = atLeast;
  for (let i = 0; i < points.length; i += POINT_STRIDE) {
    if (points[i] * x + points[i + 1] * y + points[i + 2] * z <= faintest) continue;
    const behind = -(points[i + 3] * x + points[i + 4] * y + points[i + 5] * z);
    if (behind * cosine + points[i + 6] * sine <= farthest) continue;
    farthest = Math.max(farthest, mostBehind(behind, points[i + 6], cell));
  }
  return farthest;
}

/** The most that a point at `length` from the centre, `behind` it for the cell's middle, is behind it in the cell. */
function mostBehind(behind: number, length: number, { cosine, sine }: Cell): number {
  if (behind >= length * cosine) return length;
  return behind * cosine + Math.sqrt(Math.max(0, length * length - behind * behind)) * sine;
}
