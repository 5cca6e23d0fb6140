/** Lobes of a puff that has only a picture: they throw its shadow, and are what is drawn unless it is a billboard. */
import { ShapeError } from '../../../base/errors.ts';
import type { Work } from '../../../base/work.ts';
import { discsInside } from '../billboards/inscribedDiscs.ts';
import { PUFF_PAD } from '../billboards/rasterise.ts';
import { reachOf } from '../lobes.ts';
import type { Lobe, PuffTile } from '../shapes.ts';

/** Minimum radius of the largest disc in the mask, in texels. */
const MIN_RADIUS = 2;

/**
 * Balls whose middles are discs in the mask, and whose fronts are at its depth there.
 * @throws ShapeError if the mask has no room for a disc
 */
export function* coveringLobes(tile: PuffTile): Work<Lobe[]> {
  const { size, pad } = tile;
  // Distances are to what is not covered, so the grid has an empty cell on each side of the tile.
  const cells = size + 2;
  const discs = yield* discsInside(framed(tile, cells), cells);
  const scale = (pad * cells) / (size * PUFF_PAD);
  if (discs[0].radius * scale < (MIN_RADIUS * 2 * pad) / size) {
    throw new ShapeError('A puff of the sheet is too thin: no disc fits into its mask, which is alpha of 128 or more.');
  }
  const lobes = discs.map(({ center: [x, y], radius }) => raised(tile, x * scale, y * scale, radius * scale));
  const reach = Math.max(1, reachOf(lobes));
  return lobes.map(({ center: [x, y, z], radius }): Lobe => {
    return { center: [x / reach, y / reach, z / reach], radius: radius / reach };
  });
}

/** What a tile covers, row 0 at the bottom. */
function framed({ size, mask }: PuffTile, cells: number): Uint8Array {
  const inside = new Uint8Array(cells * cells);
  for (let texel = 0; texel < size * size; texel++) {
    const [column, row] = [texel % size, Math.floor(texel / size)];
    if (mask[texel] >= 0.5) inside[(size - row) * cells + column + 1] = 1;
  }
  return inside;
}

/** Not behind the centre plane, and not out of the unit ball. */
function raised({ size, pad, depths }: PuffTile, x: number, y: number, radius: number): Lobe {
  const column = Math.min(size - 1, Math.floor((x / pad + 1) * 0.5 * size));
  const row = Math.min(size - 1, Math.floor((1 - y / pad) * 0.5 * size));
  const height = depths[row * size + column] * 2 * pad - radius;
  const highest = Math.sqrt(Math.max(0, (1 - radius) ** 2 - x * x - y * y));
  return { center: [x, y, Math.min(highest, Math.max(0, height))], radius };
}
