/** Converts the tile of a puff sheet to the raster that billboards are baked from. */
import { PUFF_PAD, SUPERSAMPLE, type PuffRaster } from './rasterise.ts';
import type { PuffTile } from '../shapes.ts';
import type { Work } from '../../../base/work.ts';

/** Texels in a slice of about two milliseconds. */
const TEXELS_A_SLICE = 1_000;

/** Resamples a tile to `size` by `size` texels, in slices of a few milliseconds. Row 0 of the raster is its bottom. */
export function* resamplingTile(tile: PuffTile, size: number): Work<PuffRaster> {
  const cells = size * SUPERSAMPLE;
  const raster: PuffRaster = {
    size,
    normals: new Float32Array(3 * size * size),
    depths: new Float32Array(size * size).fill(-Infinity),
    colors: tile.colors && new Float32Array(3 * size * size),
    coverage: new Uint8Array(cells * cells),
  };
  const reader = new TileReader(tile, cells);
  for (let texel = 0; texel < size * size; texel++) {
    gather(reader, raster, texel);
    if (texel % TEXELS_A_SLICE === TEXELS_A_SLICE - 1) yield;
  }
  return raster;
}

/** Writes the means over the covered cells of a texel. */
function gather(reader: TileReader, { size, normals, depths, colors, coverage }: PuffRaster, texel: number): void {
  const [x, y] = [texel % size, Math.floor(texel / size)];
  const cells = size * SUPERSAMPLE;
  const sum = reader.clear();
  for (let j = y * SUPERSAMPLE; j < (y + 1) * SUPERSAMPLE; j++) {
    for (let i = x * SUPERSAMPLE; i < (x + 1) * SUPERSAMPLE; i++) {
      if (reader.add(i, j)) coverage[j * cells + i] = 1;
    }
  }
  if (sum.weight === 0) return;
  const length = Math.hypot(sum.x, sum.y, sum.z);
  // Opposite normals cancel out.
  normals.set(length > 0 ? [sum.x / length, sum.y / length, sum.z / length] : [0, 0, 1], 3 * texel);
  depths[texel] = (sum.depth / sum.weight) * reader.quadsPerTile;
  colors?.set([sum.red / sum.weight, sum.green / sum.weight, sum.blue / sum.weight], 3 * texel);
}

/** Sums the channels of a tile over cells of the raster. */
class TileReader {
  /** Width of the tile in quad widths. */
  readonly quadsPerTile: number;
  private readonly tile: PuffTile;
  private readonly cells: number;
  private readonly isFine: boolean;
  private readonly sum = { weight: 0, x: 0, y: 0, z: 0, depth: 0, red: 0, green: 0, blue: 0 };

  constructor(tile: PuffTile, cells: number) {
    this.tile = tile;
    this.cells = cells;
    this.quadsPerTile = tile.pad / PUFF_PAD;
    // Texels that are not larger than those of the raster are averaged as they are, so a sheet of the same size is
    // copied exactly. Larger ones would show as squares.
    this.isFine = tile.size >= (cells / SUPERSAMPLE) * this.quadsPerTile;
  }

  clear() {
    return Object.assign(this.sum, { weight: 0, x: 0, y: 0, z: 0, depth: 0, red: 0, green: 0, blue: 0 });
  }

  /** Adds the cell in column i and row j from the bottom, if it is covered. Returns whether it is. */
  add(i: number, j: number): boolean {
    const { size, mask } = this.tile;
    const scale = size / (this.cells * this.quadsPerTile);
    const x = (i + 0.5 - this.cells / 2) * scale + size / 2 - 0.5;
    const y = (this.cells / 2 - 0.5 - j) * scale + size / 2 - 0.5;
    if (x < -0.5 || y < -0.5 || x > size - 0.5 || y > size - 0.5) return false;
    const [left, top] = [Math.floor(x), Math.floor(y)];
    const [right, down] = [x - left, y - top];
    const [west, east] = [Math.max(0, left), Math.min(size - 1, left + 1)];
    const [north, south] = [Math.max(0, top) * size, Math.min(size - 1, top + 1) * size];
    const a = (1 - right) * (1 - down) * mask[north + west];
    const b = right * (1 - down) * mask[north + east];
    const c = (1 - right) * down * mask[south + west];
    const d = right * down * mask[south + east];
    if (a + b + c + d < 0.5) return false;
    const nearest = (down < 0.5 ? north : south) + (right < 0.5 ? west : east);
    if (this.isFine && mask[nearest] > 0) {
      this.addTexel(nearest, mask[nearest]);
      return true;
    }
    this.addTexel(north + west, a);
    this.addTexel(north + east, b);
    this.addTexel(south + west, c);
    this.addTexel(south + east, d);
    return true;
  }

  /** @param weight contains the mask, because a texel that is not covered may have any colour */
  private addTexel(texel: number, weight: number): void {
    const { normals, depths, colors } = this.tile;
    const { sum } = this;
    sum.weight += weight;
    sum.x += weight * normals[3 * texel];
    sum.y += weight * normals[3 * texel + 1];
    sum.z += weight * normals[3 * texel + 2];
    sum.depth += weight * depths[texel];
    if (!colors) return;
    sum.red += weight * colors[3 * texel];
    sum.green += weight * colors[3 * texel + 1];
    sum.blue += weight * colors[3 * texel + 2];
  }
}
