/**
 * Where a puff's shadow volume may begin: behind every point of the puff that is still lit, so that a lone puff never
 * masks its own lit pixels, whatever its lobes do. Tabulated over the directions towards the light, because lobes make
 * it jump; it depends on where the ramp turns from shade to light and is baked anew when that moves.
 *
 * The table is read at the nearest entry. An entry bounds all directions of its cell, not only the one in its middle:
 * a point counts if it can be lit from anywhere in the cell, with the largest distance it can have from there.
 */
import { PatchBounds, type Cell } from './patchBounds.ts';
import { POINT_STRIDE, type Patch } from './patches.ts';
import type { Vector } from '../vector.ts';
import { finished, type Work } from '../work.ts';

/** Columns of a table: azimuth of the light about the view axis. */
export const CAP_COLUMNS = 64;
/** Rows of a table: angle between light and view axis. */
export const CAP_ROWS = 32;
/** Neighbouring entries along each side of the table for which patches are chosen together; divides both. */
const BLOCK = 8;

/**
 * Start caps of all variations. `values[(layer * height + row) * width + column]` is the largest -(p . L) over the
 * points p of a puff's surface with N . L above the threshold: how far behind the centre plane across L the farthest lit
 * point lies, in particle radii. For the direction L towards the light in the puff's own space,
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
  return joined(surfaces.map((patches) => bakeTable(patches, litThreshold)));
}

/** The tables of single variations as those of one set of puffs. */
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

/** As {@link bakeTable}, in pieces of about a millisecond. */
export function* bakingTable(patches: readonly Patch[], litThreshold: number): Work<Float32Array> {
  const table = new Float32Array(CAP_COLUMNS * CAP_ROWS);
  const bounds = new PatchBounds(patches, Math.acos(litThreshold));
  for (let row = 0; row < CAP_ROWS; row += BLOCK) {
    for (let column = 0; column < CAP_COLUMNS; column += BLOCK) {
      bakeBlock(bounds, row, column, table);
      yield;
    }
  }
  return table;
}

/** The start cap of a layer for a unit direction towards the light, as the shader reads it. */
export function startCapAt({ width, height, values }: StartCaps, layer: number, [x, y, z]: Vector): number {
  const column = Math.floor((Math.atan2(y, x) / (2 * Math.PI) + 0.5) * width);
  const row = Math.floor((Math.acos(Math.min(1, Math.max(-1, z))) / Math.PI) * height);
  return values[(layer * height + Math.min(row, height - 1)) * width + Math.min(column, width - 1)];
}

/**
 * A cap that serves every ramp from all sides: no point with N . L > 0 lies farther behind. A point is farthest behind the
 * centre when the light grazes it, or when the light comes from the centre's far side.
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

/** The directions of `count` entries along both sides of the table, from this one on. */
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

/** Fills a block of entries: patches are chosen for all of it, then for each entry. */
function bakeBlock(bounds: PatchBounds, row: number, column: number, table: Float32Array): void {
  bounds.choose(cellAt(row, column, BLOCK));
  for (let j = row; j < row + BLOCK; j++) {
    for (let i = column; i < column + BLOCK; i++) table[j * CAP_COLUMNS + i] = bounds.farthestFrom(cellAt(j, i, 1));
  }
}
