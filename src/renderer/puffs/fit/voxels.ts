/** Voxelisation of a closed mesh, with a distance field of its inside. */
import type { ClosedMesh } from './closedMesh.ts';

/** Half the width of the grid, in radii of the unit ball. It leaves a margin of more than one voxel on all sides. */
export const HALF_GRID = 1.1;
/** Offset of the columns in voxels, so that they do not hit edges of meshes with integer coordinates. */
const ASIDE = [0.0137, 0.0071] as const;

/** A cube of voxels about the origin. Voxel (i, j, k) has the index (k * size + j) * size + i. */
export interface Voxels {
  /** Voxels along each side. */
  readonly size: number;
  /** Width of a voxel, in radii of the unit ball. */
  readonly width: number;
  /** 1 if the centre of the voxel is inside. */
  readonly inside: Uint8Array;
}

/** Coordinate of the voxel centre at `index` along a side. */
export function centreOf(index: number, width: number): number {
  return (index + 0.5) * width - HALF_GRID;
}

/** Voxelises a mesh by its winding number along the columns of the grid. Overlapping closed parts form a union. */
export function voxelsOf(mesh: ClosedMesh, size: number): Voxels {
  const width = (2 * HALF_GRID) / size;
  const crossings = new Int16Array(size ** 3);
  for (let at = 0; at < mesh.indices.length; at += 3) countCrossings(mesh, at, size, width, crossings);
  return { size, width, inside: filled(crossings, size) };
}

function countCrossings(
  { positions, indices }: ClosedMesh,
  at: number,
  size: number,
  width: number,
  crossings: Int16Array,
): void {
  const corners = [indices[at], indices[at + 1], indices[at + 2]];
  const span = (axis: 0 | 1): [number, number] => {
    const places = corners.map((corner) => (positions[3 * corner + axis] + HALF_GRID) / width - 0.5);
    return [Math.max(0, Math.ceil(Math.min(...places) - 1)), Math.min(size - 1, Math.floor(Math.max(...places)))];
  };
  const [[left, right], [bottom, top]] = [span(0), span(1)];
  for (let j = bottom; j <= top; j++) {
    for (let i = left; i <= right; i++) {
      const x = centreOf(i + ASIDE[0], width);
      const y = centreOf(j + ASIDE[1], width);
      const weights = corners.map((_, k) => sideOf(positions, corners[(k + 1) % 3], corners[(k + 2) % 3], x, y));
      const isUp = weights.every((weight) => weight > 0);
      if (!isUp && !weights.every((weight) => weight < 0)) continue;
      const total = weights[0] + weights[1] + weights[2];
      const z = corners.reduce((sum, corner, k) => sum + (weights[k] / total) * positions[3 * corner + 2], 0);
      const k = Math.max(0, Math.ceil((z + HALF_GRID) / width - 0.5));
      if (k < size) crossings[(k * size + j) * size + i] += isUp ? -1 : 1;
    }
  }
}

/**
 * Edge function: the sign is the side of the edge from a to b that the point is on. The edge from b to a gives exactly
 * the negative value, so that no point falls between two triangles.
 */
function sideOf(positions: Float64Array, a: number, b: number, x: number, y: number): number {
  if (a > b) return -sideOf(positions, b, a, x, y);
  const [ax, ay] = [positions[3 * a], positions[3 * a + 1]];
  return (positions[3 * b] - ax) * (y - ay) - (positions[3 * b + 1] - ay) * (x - ax);
}

function filled(crossings: Int16Array, size: number): Uint8Array {
  const inside = new Uint8Array(size ** 3);
  const layer = size * size;
  for (let column = 0; column < layer; column++) {
    let winding = 0;
    for (let voxel = column; voxel < inside.length; voxel += layer) {
      winding += crossings[voxel];
      inside[voxel] = winding === 0 ? 0 : 1;
    }
  }
  return inside;
}

/** Distance to the surface per inside voxel, in radii of the unit ball, accurate to half a voxel; 0 outside. */
export function depthsOf({ size, width, inside }: Voxels): Float32Array {
  const squares = Float64Array.from(inside, (value) => (value === 1 ? Infinity : 0));
  for (const stride of [1, size, size * size]) alongLines(squares, size, stride);
  return Float32Array.from(squares, (square) => Math.max(0, Math.sqrt(square) - 0.5) * width);
}

/** Replaces each value by the minimum of value + squared distance along its line. Three axes give squared distances. */
function alongLines(squares: Float64Array, size: number, stride: number): void {
  const line = new Float64Array(size);
  for (let first = 0; first < squares.length; first++) {
    if (Math.floor(first / stride) % size !== 0) continue;
    for (let i = 0; i < size; i++) line[i] = squares[first + i * stride];
    for (let i = 0; i < size; i++) {
      let least = line[i];
      for (let j = 0; j < size; j++) least = Math.min(least, line[j] + (i - j) * (i - j));
      squares[first + i * stride] = least;
    }
  }
}
