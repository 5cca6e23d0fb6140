/** Validates an untrusted mesh and normalises it to the unit ball: finite, closed, of limited size. */
import { ShapeError } from '../../../base/errors.ts';
import type { PixelImage } from '../shapes.ts';

/** An arbitrary triangle mesh, of either winding. */
export interface PlainMesh {
  /** x, y, z per vertex, in any unit. */
  readonly positions: ArrayLike<number>;
  /** Three vertex indices per triangle. If absent, each three consecutive vertices form a triangle. */
  readonly indices?: ArrayLike<number>;
  /** x, y, z per vertex. If absent, edges of more than 60 degrees are sharp. */
  readonly normals?: ArrayLike<number>;
  /** Red, green, blue per vertex, sRGB, 0 to 1. They multiply the colours of the smoke. */
  readonly colors?: ArrayLike<number>;
  /** u, v per vertex: (0, 0) is the top left corner of the texture, (1, 1) the bottom right one. */
  readonly uvs?: ArrayLike<number>;
  /** Multiplies `colors`. It repeats outside (0, 0) to (1, 1). */
  readonly texture?: PixelImage;
}

/** A closed surface in the unit ball. */
export interface ClosedMesh {
  /** x, y, z per vertex, without duplicates. */
  readonly positions: Float64Array;
  readonly indices: Uint32Array;
  /** Vertex of this surface by vertex of the mesh, for those that triangles use. */
  readonly vertexOf: Uint32Array;
  /** From the mesh to the unit ball: the middle becomes the origin, the reach becomes 1. */
  readonly middle: readonly number[];
  readonly reach: number;
}

type Welded = Pick<ClosedMesh, 'positions' | 'indices' | 'vertexOf'>;

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
  requireSurface(mesh);
  const { middle, reach } = boundsOf(positions, corners);
  const unit = Float64Array.from(positions, (value, at) => (value - middle[at % 3]) / reach);
  const closed = { ...welded(unit, corners), middle, reach };
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

/** Requires numbers for each vertex, and as many pixels as the size of the texture says. */
function requireSurface({ positions, normals, colors, uvs, texture }: PlainMesh): void {
  const vertices = positions.length / 3;
  for (const [name, values, stride] of [
    ['normals', normals, 3],
    ['colors', colors, 3],
    ['uvs', uvs, 2],
  ] as const) {
    if (!values) continue;
    if (values.length === stride * vertices && Array.prototype.every.call(values, Number.isFinite)) continue;
    throw new ShapeError(`The mesh needs ${stride} finite numbers in ${name} for each of its ${vertices} vertices.`);
  }
  if (!texture) return;
  if (!uvs) throw new ShapeError('The mesh has a texture, but no uvs.');
  const { width, height, data } = texture;
  if (width > 0 && height > 0 && data?.length === 4 * width * height) return;
  throw new ShapeError(
    `The texture of the mesh has ${data?.length} bytes; ${width} x ${height} pixels need ${4 * width * height}.`,
  );
}

/** The centre of the bounding box, and the distance of the farthest vertex from it. */
function boundsOf(positions: ArrayLike<number>, corners: ArrayLike<number>): Pick<ClosedMesh, 'middle' | 'reach'> {
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
  return { middle, reach };
}

/** Merges vertices at the same position and removes the triangles that become degenerate. */
function welded(positions: Float64Array, corners: ArrayLike<number>): Welded {
  const places = new Map<string, number>();
  const kept: number[] = [];
  const vertexOf = new Uint32Array(positions.length / 3);
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
    const [a, b, c] = [0, 1, 2].map((corner) => (vertexOf[corners[at + corner]] = vertexAt(corners[at + corner])));
    if (a !== b && b !== c && c !== a) indices.push(a, b, c);
  }
  return { positions: Float64Array.from(kept), indices: Uint32Array.from(indices), vertexOf };
}

/** Each edge must be used equally often in both directions. Then the winding number is well defined. */
function requireClosed({ positions, indices }: Welded): void {
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
