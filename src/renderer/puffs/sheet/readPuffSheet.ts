/** Reads puffs from the images that artists paint or render. docs/three.md has the formats. */
import { requireOptions, ShapeError } from '../../../base/errors.ts';
import { inPieces, unlessAborted, type Work } from '../../../base/work.ts';
import { PUFF_PAD } from '../billboards/rasterise.ts';
import type { PuffShape, PuffTile } from '../shapes.ts';
import { normalsFrom, scaledDepths } from './depthNormals.ts';
import { requireSheet, type PackedPuffs, type PuffTextures, type SheetSource } from './sheet.ts';
import { coveringLobes } from './coveringLobes.ts';

export interface ReadSheetOptions {
  /** Name of the puffs. */
  readonly name?: string;
  /** Tiles along each side, 1 or 2. By default one, if the middle of the image is covered, and otherwise two. */
  readonly tiles?: 1 | 2;
  /** Where green of `normalDepth` points: `up` (OpenGL) or `down` (DirectX). By default as the slopes of the depth show. */
  readonly green?: 'up' | 'down';
  /**
   * Height of white above black in blue of `lightRimDepthMask`, in widths of a tile, above 0 and up to 2. By default the
   * nearest point is as high above the farthest as the radius of a disc with the area of the mask.
   */
  readonly relief?: number;
  /** Aborts the work. The promise then rejects with the signal's reason. */
  readonly signal?: AbortSignal;
}

/** Texels along each side of a tile that is kept. Billboards are baked from four times as many as they have. */
const MAX_TEXELS = 256;
/** Pixels along each side at which the direction of green is looked up. */
const SAMPLES = 512;

/**
 * Reads the puffs of a sheet, one of each tile that is not empty, from the top left one on in reading order. Works in
 * slices of 8 ms. With `puff.form=billboards`, puffs look like the tiles; lobes approximate their masks.
 * @throws ShapeError if the images are not of the same size, not square, too large, empty, or no sheet
 */
export async function readPuffSheet(
  sheet: PuffTextures | PackedPuffs,
  options: ReadSheetOptions = {},
): Promise<PuffShape[]> {
  requireOptions('readPuffSheet', options, ['name', 'tiles', 'green', 'relief', 'signal']);
  const { green, relief, signal } = options;
  if (green !== undefined && green !== 'up' && green !== 'down') {
    throw new ShapeError(`Green of normals cannot point ${String(green)}: use up or down.`);
  }
  if (relief !== undefined && !(relief > 0 && relief <= 2)) {
    throw new ShapeError(`The relief of a puff sheet cannot be ${relief}: use a number above 0, up to 2.`);
  }
  const source = requireSheet(sheet, options.tiles);
  return inPieces(unlessAborted(reading(source, options), signal));
}

function* reading(source: SheetSource, { name = 'sheet', green, relief }: ReadSheetOptions): Work<PuffShape[]> {
  const shapes: PuffShape[] = [];
  const up = green ? green === 'up' : pointsUp(source);
  for (let index = 0; index < source.tiles ** 2; index++) {
    const average = yield* averaging(source, index, up ? 1 : -1);
    if (!average.mask.some((share) => share >= 0.5)) continue;
    const sheet = inUnitBall(withoutWhite(source.hasNormals ? average : yield* withNormals(average, relief)));
    shapes.push({ name: `${name} ${index + 1}`, lobes: yield* coveringLobes(sheet), sheet });
  }
  if (shapes.length > 0) return shapes;
  throw new ShapeError(
    'The puff sheet is empty: no pixel has an alpha of 128 or more. Alpha is the coverage; save the image with it.',
  );
}

/** Whether green of normals is high where the depth increases downwards, at a sample of the pixels. */
function pointsUp({ surface, depthChannel, paint, tile, tiles }: SheetSource): boolean {
  const width = tile * tiles;
  const step = Math.ceil(width / SAMPLES);
  let sum = 0;
  for (let row = 0; row + 1 < width; row += step) {
    for (let column = 0; column < width; column += step) {
      const at = 4 * (row * width + column);
      const below = at + 4 * width;
      if (paint[at + 3] < 128 || paint[below + 3] < 128) continue;
      sum += (surface[at + 1] - 127.5) * (surface[below + depthChannel] - surface[at + depthChannel]);
    }
  }
  return sum >= 0;
}

/** The means of the pixels of a tile over at most `MAX_TEXELS` along each side, weighted by their coverage. */
function* averaging({ tile, tiles, hasNormals, ...source }: SheetSource, index: number, up: 1 | -1): Work<PuffTile> {
  const { surface, depthChannel, paint } = source;
  const size = Math.min(MAX_TEXELS, tile);
  const normals = new Float32Array(3 * size * size);
  const depths = new Float32Array(size * size);
  const mask = new Float32Array(size * size);
  const colors = new Float32Array(hasNormals ? 3 * size * size : 0);
  const first = (Math.floor(index / tiles) * tiles * tile + (index % tiles)) * tile;
  const edge = (texel: number) => Math.floor((texel * tile) / size);
  for (let row = 0; row < size; row++) {
    for (let column = 0; column < size; column++) {
      let [weight, depth, x, y, z, red, green, blue] = [0, 0, 0, 0, 0, 0, 0, 0];
      for (let j = edge(row); j < edge(row + 1); j++) {
        for (let i = edge(column); i < edge(column + 1); i++) {
          const at = 4 * (first + j * tiles * tile + i);
          const share = paint[at + 3];
          weight += share;
          depth += share * surface[at + depthChannel];
          if (!hasNormals) continue;
          x += share * (surface[at] - 127.5);
          y += share * (surface[at + 1] - 127.5);
          z += share * (surface[at + 2] - 127.5);
          red += share * paint[at];
          green += share * paint[at + 1];
          blue += share * paint[at + 2];
        }
      }
      if (weight === 0) continue;
      const texel = row * size + column;
      mask[texel] = weight / 255 / (edge(row + 1) - edge(row)) / (edge(column + 1) - edge(column));
      depths[texel] = depth / weight / 255 - 0.5;
      if (!hasNormals) continue;
      const length = Math.hypot(x, y, z);
      normals.set(length > 0 ? [x / length, (up * y) / length, z / length] : [0, 0, 1], 3 * texel);
      colors.set([red / weight / 255, green / weight / 255, blue / weight / 255], 3 * texel);
    }
    yield;
  }
  return { size, pad: PUFF_PAD, normals, depths, mask, colors };
}

function* withNormals(tile: PuffTile, relief: number | undefined): Work<PuffTile> {
  const scaled = { ...tile, depths: scaledDepths(tile, relief) };
  return { ...scaled, normals: yield* normalsFrom(scaled) };
}

/** Without colours if all that is covered is white, as most puffs are: their layers are the same. */
function withoutWhite(tile: PuffTile): PuffTile {
  const { mask, colors } = tile;
  const isWhite = colors!.every((share, at) => share >= 1 || mask[Math.floor(at / 3)] === 0);
  return isWhite ? { ...tile, colors: undefined } : tile;
}

/** Shrinks a tile until what it covers is in the unit ball, beyond which nothing of a billboard is drawn. */
function inUnitBall(tile: PuffTile): PuffTile {
  const { size, mask, depths, pad } = tile;
  let squared = 0;
  for (let texel = 0; texel < size * size; texel++) {
    if (mask[texel] < 0.5) continue;
    const x = ((texel % size) + 0.5) / size - 0.5;
    const y = (Math.floor(texel / size) + 0.5) / size - 0.5;
    squared = Math.max(squared, x * x + y * y + depths[texel] ** 2);
  }
  const reach = 2 * pad * Math.sqrt(squared);
  // A sheet of puffs that fit keeps its size to the bit: rounding moves what is on the ball by up to half a texel.
  return reach > 1 + pad / size ? { ...tile, pad: pad / reach } : tile;
}
