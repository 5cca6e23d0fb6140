/** Normals of tiles that have only depths. */
import { ShapeError } from '../../../base/errors.ts';
import type { Work } from '../../../base/work.ts';
import type { PuffTile } from '../shapes.ts';

/**
 * The depths above the farthest covered one, so that the rim of a puff is in its centre plane.
 * @param relief height of white above black, in widths of the tile
 * @throws ShapeError if all covered depths are the same
 */
export function scaledDepths({ size, depths, mask }: PuffTile, relief: number | undefined): Float32Array {
  let [far, near, covered] = [Infinity, -Infinity, 0];
  for (let texel = 0; texel < depths.length; texel++) {
    if (mask[texel] < 0.5) continue;
    covered++;
    far = Math.min(far, depths[texel]);
    near = Math.max(near, depths[texel]);
  }
  if (near === far) {
    throw new ShapeError('The puff sheet is flat: blue, its depth, has the same value everywhere. White must be near.');
  }
  const scale = relief ?? Math.sqrt(covered / Math.PI) / size / (near - far);
  return depths.map((depth) => (depth - far) * scale);
}

/**
 * Texels to each side of the one whose slope is measured. Bytes make steps, of which several must be in this range, or
 * they would show as facets.
 */
const REACH = 3;
/** Of the weights by distance, in texels. */
const DEVIATION = 1.8;

/** Normals of planes fitted to the covered texels around each one, by weighted least squares. */
export function* normalsFrom(tile: PuffTile): Work<Float32Array> {
  const { size, mask } = tile;
  const normals = new Float32Array(3 * size * size);
  for (let row = 0; row < size; row++) {
    for (let column = 0; column < size; column++) {
      const texel = row * size + column;
      if (mask[texel] > 0) normals.set(normalAt(tile, column, row), 3 * texel);
    }
    if (row % 8 === 7) yield;
  }
  return normals;
}

const WEIGHTS = Array.from({ length: 2 * REACH + 1 }, (_, at) => Math.exp(-(((at - REACH) / DEVIATION) ** 2) / 2));

function normalAt({ size, mask, depths }: PuffTile, column: number, row: number): number[] {
  let [sum, x, y, z, xx, xy, yy, xz, yz] = [0, 0, 0, 0, 0, 0, 0, 0, 0];
  for (let down = -REACH; down <= REACH; down++) {
    if (row + down < 0 || row + down >= size) continue;
    for (let right = -REACH; right <= REACH; right++) {
      if (column + right < 0 || column + right >= size) continue;
      const texel = (row + down) * size + column + right;
      const weight = mask[texel] * WEIGHTS[down + REACH] * WEIGHTS[right + REACH];
      const height = depths[texel] * size;
      sum += weight;
      x += weight * right;
      y -= weight * down;
      z += weight * height;
      xx += weight * right * right;
      xy -= weight * right * down;
      yy += weight * down * down;
      xz += weight * right * height;
      yz -= weight * down * height;
    }
  }
  const [a, b, c] = [xx - (x * x) / sum, xy - (x * y) / sum, yy - (y * y) / sum];
  const [p, q] = [xz - (x * z) / sum, yz - (y * z) / sum];
  const determinant = a * c - b * b;
  // Texels in a line, or a single one, have no plane.
  if (!(determinant > 1e-6 * sum * sum)) return [0, 0, 1];
  const [slopeX, slopeY] = [(p * c - q * b) / determinant, (q * a - p * b) / determinant];
  const length = Math.hypot(slopeX, slopeY, 1);
  return [-slopeX / length, -slopeY / length, 1 / length];
}
