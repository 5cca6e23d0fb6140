/** Draws puffs as the two textures of Fig. 3 of McGuire and Fein (2006). docs/three.md has the format. */
import { requireOptions, ShapeError } from '../../../base/errors.ts';
import { inPieces, unlessAborted, type Work } from '../../../base/work.ts';
import { findingCovered, rasterisingShape } from '../billboards/layers.ts';
import { SUPERSAMPLE, type PuffRaster } from '../billboards/rasterise.ts';
import { billboardShapes } from '../billboards/sides.ts';
import { requireShapes } from '../lobes.ts';
import type { PuffShape } from '../shapes.ts';
import { MAX_TILES, MIN_TILE, type PuffTextures } from './sheet.ts';

export interface WriteSheetOptions {
  /** Pixels along each side of a tile, a whole number from 16 to 512. Default 256. */
  readonly size?: number;
  /** Aborts the work. The promise then rejects with the signal's reason. */
  readonly signal?: AbortSignal;
}

/** Rasterising takes 16 cells of 9 bytes for each pixel. */
const MAX_SIZE = 512;

interface PixelTextures {
  readonly width: number;
  readonly normalDepth: Uint8ClampedArray<ArrayBuffer>;
  readonly colorCoverage: Uint8ClampedArray<ArrayBuffer>;
}

/**
 * Draws the fronts of up to four shapes, as `puff.form=billboards` shows them: one shape fills the images, more are in
 * two rows of two tiles. Works in slices of 8 ms. `readPuffSheet` reads the result.
 * @throws ShapeError if there are more than four shapes, a shape is invalid, or `size` is
 */
export async function writePuffSheet(
  shapes: readonly PuffShape[],
  options: WriteSheetOptions = {},
): Promise<PuffTextures> {
  requireOptions('writePuffSheet', options, ['size', 'signal']);
  const { size = 256, signal } = options;
  if (!Array.isArray(shapes)) throw new ShapeError('A puff sheet takes an array of puff shapes.');
  if (shapes.length > MAX_TILES ** 2) {
    throw new ShapeError(`A puff sheet cannot hold ${shapes.length} shapes: the limit is ${MAX_TILES ** 2}.`);
  }
  requireShapes(shapes);
  if (!Number.isInteger(size) || size < MIN_TILE || size > MAX_SIZE) {
    throw new ShapeError(`A tile cannot have ${size} pixels: use a whole number from ${MIN_TILE} to ${MAX_SIZE}.`);
  }
  return inPieces(unlessAborted(writing(billboardShapes(shapes), size), signal));
}

function* writing(shapes: readonly PuffShape[], size: number): Work<PuffTextures> {
  const tiles = shapes.length > 1 ? MAX_TILES : 1;
  const width = tiles * size;
  const pixels = { width, normalDepth: blank(width, 128), colorCoverage: blank(width, 255) };
  for (const [index, shape] of shapes.entries()) {
    const raster = yield* rasterisingShape(shape, size);
    const nearest = yield* findingCovered(raster);
    const first = (Math.floor(index / tiles) * width + (index % tiles)) * size;
    for (let row = 0; row < size; row++) {
      for (let column = 0; column < size; column++) {
        const texel = (size - 1 - row) * size + column;
        writeTexel(raster, texel, nearest[texel], pixels, first + row * width + column);
      }
      if (row % 16 === 15) yield;
    }
  }
  const image = (data: Uint8ClampedArray<ArrayBuffer>) => ({ width, height: width, data });
  return { normalDepth: image(pixels.normalDepth), colorCoverage: image(pixels.colorCoverage) };
}

/** An image of normals towards the viewer at depth 0, or of white that covers nothing. */
function blank(width: number, red: 128 | 255): Uint8ClampedArray<ArrayBuffer> {
  const data = new Uint8ClampedArray(4 * width * width);
  const color = red === 128 ? [128, 128, 255, 128] : [255, 255, 255, 0];
  for (let at = 0; at < data.length; at += 4) data.set(color, at);
  return data;
}

/** @param from the nearest covered texel, so that filtering mixes in no background */
function writeTexel(raster: PuffRaster, texel: number, from: number, pixels: PixelTextures, pixel: number): void {
  const { normals, depths, colors } = raster;
  const { normalDepth, colorCoverage } = pixels;
  for (let axis = 0; axis < 3; axis++) {
    normalDepth[4 * pixel + axis] = 127.5 * (normals[3 * from + axis] + 1);
    if (colors) colorCoverage[4 * pixel + axis] = 255 * colors[3 * from + axis];
  }
  normalDepth[4 * pixel + 3] = 255 * (depths[from] + 0.5);
  colorCoverage[4 * pixel + 3] = 255 * coverageOf(raster, texel);
}

/** The covered share of a texel. */
function coverageOf({ size, coverage }: PuffRaster, texel: number): number {
  const [x, y] = [texel % size, Math.floor(texel / size)];
  let covered = 0;
  for (let j = 0; j < SUPERSAMPLE; j++) {
    const first = (y * SUPERSAMPLE + j) * size * SUPERSAMPLE + x * SUPERSAMPLE;
    for (let i = 0; i < SUPERSAMPLE; i++) covered += coverage[first + i];
  }
  return covered / SUPERSAMPLE ** 2;
}
