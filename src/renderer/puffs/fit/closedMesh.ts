/** Validates an untrusted mesh and normalises it to the unit ball: finite, closed, of limited size. */
import { ShapeError } from '../../../base/errors.ts';

/** An arbitrary triangle mesh, of either winding. */
export interface PlainMesh {
  /** x, y, z per vertex, in any unit. */
  readonly positions: ArrayLike<number>;
  /** Three vertex indices per triangle. If absent, each three consecutive vertices form a triangle. */
  readonly indices?: ArrayLike<number>;
}

/** A closed surface in the unit ball. */
export interface ClosedMesh {
  /** x, y, z per vertex, without duplicates. */
  readonly positions: Float64Array;
  readonly indices: Uint32Array;
}

/** Maximum number of triangles of a mesh. */
export const MAX_TRIANGLES = 250_000;
/** Weld distance relative to the mesh's radius. Files duplicate vertices that have several normals. */
const WELD = 1e-5;
/** A mesh with fewer triangles encloses no volume. */
const MIN_TRIANGLES = 4;

/** @throws ShapeError with the fault of the mesh and what is accepted */
export function closedMesh(mesh: PlainMesh): ClosedMesh {
  if (typeof (mesh as PlainMesh | undefined)?.positions?.length !== 'number')
    throw new ShapeError('This is not a mesh: it needs an array of positions, x, y, z per vertex.');
  const { positions, indices } = mesh;
  const corners = indices ?? Uint32Array.from({ length: positions.length / 3 }, (_, vertex) => vertex);
  requireNumbers(positions, corners);
  const unit = inUnitBall(positions, corners);
  const closed = welded(unit, corners);
  requireClosed(closed);
  return closed;
}

function requireNumbers(positions: ArrayLike<number>, corners: ArrayLike<number>): void {
  const triangles = corners.length / 3;
  if (triangles === 0) throw new ShapeError('The mesh is empty: it has no triangles.');
  if (!Number.isInteger(triangles) || positions.length % 3 !== 0) {
    throw new ShapeError('The mesh is incomplete: each triangle needs three indices and each vertex three numbers.');
  }
  if (triangles > MAX_TRIANGLES) {
    throw new ShapeError(`The mesh has ${triangles} triangles; the limit is ${MAX_TRIANGLES}. Simplify it first.`);
  }
  for (let at = 0; at < positions.length; at++) {
    if (!Number.isFinite(positions[at])) {
      throw new ShapeError(
        `Vertex ${Math.floor(at / 3)} of the mesh has the coordinate ${positions[at]}; it must be finite.`,
      );
    }
  }
  for (let at = 0; at < corners.length; at++) {
    if (!(corners[at] >= 0 && corners[at] < positions.length / 3)) {
      throw new ShapeError(
        `Triangle ${Math.floor(at / 3)} of the mesh uses vertex ${corners[at]}, which does not exist.`,
      );
    }
  }
}

/** Centres the bounding box at the origin and scales the farthest vertex to distance 1. */
function inUnitBall(positions: ArrayLike<number>, corners: ArrayLike<number>): Float64Array {
  const [low, high] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]]; // prettier-ignore
  for (let at = 0; at < corners.length; at++) {
    for (let axis = 0; axis < 3; axis++) {
      low[axis] = Math.min(low[axis], positions[3 * corners[at] + axis]);
      high[axis] = Math.max(high[axis], positions[3 * corners[at] + axis]);
    }
  }
  const middle = low.map((value, axis) => (value + high[axis]) / 2);
  let reach = 0;
  for (let at = 0; at < corners.length; at++) {
    const offset = middle.map((value, axis) => positions[3 * corners[at] + axis] - value);
    reach = Math.max(reach, Math.hypot(...offset));
  }
  if (!(reach > 0 && reach < Infinity))
    throw new ShapeError('The mesh has no size: all its vertices are at one point.');
  return Float64Array.from(positions, (value, at) => (value - middle[at % 3]) / reach);
}

/** Merges vertices at the same position and removes the triangles that become degenerate. */
function welded(positions: Float64Array, corners: ArrayLike<number>): ClosedMesh {
  const places = new Map<string, number>();
  const kept: number[] = [];
  const vertexAt = (corner: number): number => {
    const [x, y, z] = positions.subarray(3 * corner, 3 * corner + 3);
    const place = `${Math.round(x / WELD)},${Math.round(y / WELD)},${Math.round(z / WELD)}`;
    const found = places.get(place);
    if (found !== undefined) return found;
    places.set(place, kept.length / 3);
    return kept.push(x, y, z) / 3 - 1;
  };
  const indices: number[] = [];
  for (let at = 0; at < corners.length; at += 3) {
    const [a, b, c] = [vertexAt(corners[at]), vertexAt(corners[at + 1]), vertexAt(corners[at + 2])];
    if (a !== b && b !== c && c !== a) indices.push(a, b, c);
  }
  return { positions: Float64Array.from(kept), indices: Uint32Array.from(indices) };
}

/** Each edge must be used equally often in both directions. Then the winding number is well defined. */
function requireClosed({ positions, indices }: ClosedMesh): void {
  if (indices.length / 3 < MIN_TRIANGLES)
    throw new ShapeError('The mesh encloses no volume: it has fewer than 4 triangles.');
  const vertices = positions.length / 3;
  const passes = new Map<number, number>();
  for (let at = 0; at < indices.length; at++) {
    const [from, to] = [indices[at], indices[at % 3 === 2 ? at - 2 : at + 1]];
    const edge = Math.min(from, to) * vertices + Math.max(from, to);
    passes.set(edge, (passes.get(edge) ?? 0) + (from < to ? 1 : -1));
  }
  const open = [...passes.values()].filter((count) => count !== 0).length;
  if (open === 0) return;
  throw new ShapeError(
    `The mesh is open: ${open} of its ${passes.size} edges have a triangle on one side only, or triangles that face ` +
      'opposite ways. Close its holes and make its normals consistent first.',
  );
}
