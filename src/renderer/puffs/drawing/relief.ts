/**
 * Inflates a drawing to a relief, as billboards are baked from. The height over a silhouette is the square root of u,
 * where the Laplacian of u is -4 and u is 0 along the outline: half a ball over a disc, and smooth over every shape,
 * unlike the distance to the outline itself. The outline is that of the signed distance, between the points of the
 * grid: see Gibou, Fedkiw, Cheng and Kang, 'A Second-Order-Accurate Symmetric Discretization of the Poisson Equation on
 * Irregular Domains' (Journal of Computational Physics 176, 2002). Along folds u is drawn down to a valley.
 */
import { SIDE, type DrawnArea, type Line, type PuffDrawing } from './drawing.ts';
import { measuringDistance } from '../billboards/distance.ts';
import { PUFF_PAD, SUPERSAMPLE, type PuffRaster } from '../billboards/rasterise.ts';
import type { Work } from '../../../base/work.ts';

/** Part of the height of half a ball that a disc has. */
const HEIGHT = 0.85;
/** Half the width of the valley of a fold, in particle radii, and how strongly u is drawn to 0 in its middle. */
const FOLD_WIDTH = 0.045;
const FOLD_STRENGTH = 1600;
/** Least part of the way to a neighbour at which the outline is assumed, which bounds the weights. */
const MIN_WAY = 0.05;
/** Rounds of successive over-relaxation, in slices of about two milliseconds. */
const ROUNDS = 240;
const ROUNDS_A_SLICE = 8;
const ROWS_A_SLICE = 32;
const TEXELS_A_SLICE = 1_000;

/** Replaces a drawing that covers nothing. */
const DOT: PuffDrawing = {
  areas: [{ color: '#ffffff', outlines: [[[118, 118], [138, 118], [138, 138], [118, 138]]] }],
  folds: [],
}; // prettier-ignore

/** Draws a drawing to the grids that billboards are baked from. */
export function* rasterisingDrawing(drawing: PuffDrawing, size: number): Work<PuffRaster> {
  const cells = size * SUPERSAMPLE;
  const toCells = placementOf(drawing, cells);
  const paint = yield* painting(drawing.areas, toCells, cells);
  const coverage = coverageOf(paint);
  yield;
  const distance = yield* measuringDistance(coverage, cells);
  const inside = inTexels(distance, size);
  if (!inside.some((away) => away < 0)) return yield* rasterisingDrawing(DOT, size);
  yield;
  const pull = drawing.folds.length > 0 ? yield* foldPull(drawing.folds, toCells, size) : undefined;
  const squares = yield* solving(inside, pull, size);
  const colors = yield* meanColors(drawing.areas, paint, size);
  return { size, coverage, colors, ...surfaceOf(squares, inside, size) };
}

/** Converts a place of the sheet to cells, with y up and centres of cells at whole numbers. */
type Placement = (x: number, y: number) => readonly [x: number, y: number];

/** A silhouette beyond the unit circle shrinks to fit, because nothing of a billboard is drawn there. */
export function placementOf({ areas }: PuffDrawing, cells: number): Placement {
  const half = SIDE / 2;
  let reach = half;
  for (const { outlines } of areas) {
    for (const [x, y] of outlines.flat()) reach = Math.max(reach, Math.sqrt((x - half) ** 2 + (y - half) ** 2));
  }
  const place = (from: number): number => (from / reach / PUFF_PAD + 1) * 0.5 * cells - 0.5;
  return (x, y) => [place(x - half), place(half - y)];
}

/** The topmost area at each cell; -1 where there is none. */
export function* painting(areas: readonly DrawnArea[], toCells: Placement, cells: number): Work<Int8Array> {
  const paint = new Int8Array(cells * cells).fill(-1);
  for (const [index, { outlines }] of areas.entries()) {
    const rings = outlines.map((line) => line.map(([x, y]) => toCells(x, y)));
    for (let row = 0; row < cells; row++) {
      const crossings = crossingsOf(rings, row);
      for (let at = 0; at + 1 < crossings.length; at += 2) {
        const [from, to] = [Math.max(0, Math.ceil(crossings[at])), Math.min(cells, Math.ceil(crossings[at + 1]))];
        if (from < to) paint.fill(index, row * cells + from, row * cells + to);
      }
      if (row % ROWS_A_SLICE === 0) yield;
    }
  }
  return paint;
}

/** The x at which closed lines cross a row, ascending. */
function crossingsOf(rings: readonly (readonly (readonly [number, number])[])[], row: number): number[] {
  const crossings: number[] = [];
  for (const ring of rings) {
    for (let at = 0; at < ring.length; at++) {
      const [[ax, ay], [bx, by]] = [ring[at], ring[(at + 1) % ring.length]];
      if (ay <= row !== by <= row) crossings.push(ax + ((row - ay) / (by - ay)) * (bx - ax));
    }
  }
  return crossings.sort((a, b) => a - b);
}

/** 1 where an area is, else 0. */
export function coverageOf(paint: Int8Array): Uint8Array {
  // TypedArray.from takes 20 times as long.
  const coverage = new Uint8Array(paint.length);
  for (let cell = 0; cell < paint.length; cell++) coverage[cell] = paint[cell] < 0 ? 0 : 1;
  return coverage;
}

/** The signed distance at the centres of texels, in texels; negative inside. */
function inTexels(distance: Float32Array, size: number): Float32Array {
  const cells = size * SUPERSAMPLE;
  const half = SUPERSAMPLE / 2;
  return Float32Array.from({ length: size * size }, (_, texel) => {
    const corner = (Math.floor(texel / size) * SUPERSAMPLE + half) * cells + (texel % size) * SUPERSAMPLE + half;
    const sum = distance[corner] + distance[corner - 1] + distance[corner - cells] + distance[corner - cells - 1];
    return sum / 4 / SUPERSAMPLE;
  });
}

/** How strongly folds draw u to 0 at each texel. */
function* foldPull(folds: readonly Line[], toCells: Placement, size: number): Work<Float32Array> {
  const pull = new Float32Array(size * size);
  const texels = (cell: number): number => (cell + 0.5) / SUPERSAMPLE - 0.5;
  const width = (FOLD_WIDTH / (2 * PUFF_PAD)) * size;
  for (const line of folds) {
    const points = line.map(([x, y]) => toCells(x, y).map(texels));
    for (let at = 0; at + 1 < points.length; at++) pullTowards(points[at], points[at + 1], width, pull, size);
    yield;
  }
  return pull;
}

/** Raises the pull around a straight line. */
function pullTowards(
  [ax, ay]: readonly number[],
  [bx, by]: readonly number[],
  width: number,
  pull: Float32Array,
  size: number,
): void {
  const [dx, dy] = [bx - ax, by - ay];
  const squared = Math.max(1e-9, dx * dx + dy * dy);
  const first = (a: number, b: number): number => Math.max(0, Math.ceil(Math.min(a, b) - width));
  const last = (a: number, b: number): number => Math.min(size - 1, Math.floor(Math.max(a, b) + width));
  for (let y = first(ay, by); y <= last(ay, by); y++) {
    for (let x = first(ax, bx); x <= last(ax, bx); x++) {
      const along = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / squared));
      const away = Math.sqrt((x - ax - along * dx) ** 2 + (y - ay - along * dy) ** 2);
      const strength = Math.max(0, 1 - away / width) * FOLD_STRENGTH * ((2 * PUFF_PAD) / size) ** 2;
      pull[y * size + x] = Math.max(pull[y * size + x], strength);
    }
  }
}

/** Solves for u in squared texels, 0 outside. */
function* solving(inside: Float32Array, pull: Float32Array | undefined, size: number): Work<Float32Array> {
  const neighbours = [-1, 1, -size, size];
  const texels = [...inside.keys()].filter((texel) => inside[texel] < 0);
  const weights = Float32Array.from(texels, (texel) => {
    const ways = neighbours.map((step) => (inside[texel + step] < 0 ? 1 : 1 / wayOut(inside, texel, step)));
    return ways.reduce((sum, weight) => sum + weight, pull?.[texel] ?? 0);
  });
  const u = new Float32Array(size * size);
  // The best factor for a square of the silhouette's width.
  const relaxation = 2 / (1 + Math.sin((Math.PI * 2 * PUFF_PAD) / size));
  for (let round = 0; round < ROUNDS; round++) {
    for (let at = 0; at < texels.length; at++) {
      const texel = texels[at];
      const sum = u[texel - 1] + u[texel + 1] + u[texel - size] + u[texel + size];
      u[texel] += relaxation * ((sum + 4) / weights[at] - u[texel]);
    }
    if (round % ROUNDS_A_SLICE === 0) yield;
  }
  return u;
}

/** Part of the way from a texel inside to its neighbour outside at which the outline is. */
function wayOut(inside: Float32Array, texel: number, step: number): number {
  return Math.max(MIN_WAY, inside[texel] / (inside[texel] - inside[texel + step]));
}

/** Normals and depths of the height sqrt(u). */
function surfaceOf(u: Float32Array, inside: Float32Array, size: number): Pick<PuffRaster, 'normals' | 'depths'> {
  const normals = new Float32Array(3 * size * size);
  const depths = new Float32Array(size * size).fill(-Infinity);
  const slope = (texel: number, step: number): number => {
    const at = (side: number): [value: number, way: number] =>
      inside[texel + side] < 0 ? [u[texel + side], 1] : [0, wayOut(inside, texel, side)];
    const [[before, back], [after, ahead]] = [at(-step), at(step)];
    return (after - before) / (back + ahead);
  };
  for (let texel = 0; texel < size * size; texel++) {
    if (!(inside[texel] < 0)) continue;
    const height = Math.sqrt(Math.max(0, u[texel])) * HEIGHT;
    const [x, y] = [slope(texel, 1), slope(texel, size)].map((rise) => (-rise * HEIGHT * HEIGHT) / 2);
    const length = Math.sqrt(x * x + y * y + height * height);
    normals.set(length > 1e-6 ? [x / length, y / length, height / length] : [0, 0, 1], 3 * texel);
    depths[texel] = height / size;
  }
  return { normals, depths };
}

/** The mean colour of the covered cells of each texel. */
function* meanColors(areas: readonly DrawnArea[], paint: Int8Array, size: number): Work<Float32Array> {
  const cells = size * SUPERSAMPLE;
  const shares = areas.map(({ color }) => [1, 3, 5].map((at) => parseInt(color.slice(at, at + 2), 16) / 255));
  const colors = new Float32Array(3 * size * size);
  for (let texel = 0; texel < size * size; texel++) {
    const corner = Math.floor(texel / size) * SUPERSAMPLE * cells + (texel % size) * SUPERSAMPLE;
    let covered = 0;
    for (let cell = 0; cell < SUPERSAMPLE * SUPERSAMPLE; cell++) {
      const area = paint[corner + Math.floor(cell / SUPERSAMPLE) * cells + (cell % SUPERSAMPLE)];
      if (area < 0) continue;
      covered++;
      for (let channel = 0; channel < 3; channel++) colors[3 * texel + channel] += shares[area][channel];
    }
    for (let channel = 0; channel < 3; channel++) colors[3 * texel + channel] /= Math.max(1, covered);
    if (texel % TEXELS_A_SLICE === 0) yield;
  }
  return colors;
}
