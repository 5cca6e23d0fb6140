import type { Work } from '../../base/work.ts';
import { EdgeTable, mixed } from './edges/edgeTable.ts';
import { memoize } from './memoize.ts';
import { PLACES_PER_METRE } from '../../base/constants.ts';

/**
 * A triangle mesh as flat arrays: xyz positions, unit normals, three indices a triangle, counterclockwise front faces.
 */
export interface TriangleMesh {
  positions: Float32Array;
  normals: Float32Array;
  indices: Uint32Array;
  /**
   * Fewer triangles on the same vertices, which deviate from the mesh by about this many metres. They are closed if
   * the mesh is.
   */
  coarser?: (deviation: number) => Uint32Array;
}

/** Twice the area of a triangle, in square metres, below which it has no normal. */
const NO_AREA = 1e-12;

/** A closed mesh from which a shadow volume can be extruded. Vertices at the same position are one vertex. */
export interface Extrusion {
  /** xyz of each vertex. */
  positions: Float32Array;
  /** Three vertices of each face, counterclockwise. */
  corners: Uint32Array;
  /** xyz of the unit normal of each face; zero for a face without area. */
  normals: Float32Array;
  /** For each edge: its start and end as its first face winds, then the first and the second face. */
  edges: Uint32Array;
  longestEdge: number;
}

/** Concatenates arrays. */
export function inOne(arrays: readonly Float32Array[]): Float32Array {
  const result = new Float32Array(arrays.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const array of arrays) {
    result.set(array, at);
    at += array.length;
  }
  return result;
}

/**
 * Maps each vertex to the first vertex at the same position. Creases duplicate vertices, but the shape is connected
 * there.
 */
export const weld = memoize((positions: Float32Array): Uint32Array => {
  const places = new Float64Array(positions.length);
  for (let at = 0; at < places.length; ++at) places[at] = Math.round(positions[at] * PLACES_PER_METRE);
  const welded = new Uint32Array(positions.length / 3);
  const slots = new Int32Array(2 ** Math.ceil(Math.log2(2 * welded.length + 1))).fill(-1);
  for (let vertex = 0; vertex < welded.length; ++vertex) {
    let slot = hashOf(places, vertex) & (slots.length - 1);
    while (slots[slot] >= 0 && !isSamePlace(places, slots[slot], vertex)) slot = (slot + 1) & (slots.length - 1);
    if (slots[slot] < 0) slots[slot] = vertex;
    welded[vertex] = slots[slot];
  }
  return welded;
});

/**
 * Spatial hash of Teschner et al., 'Optimized Spatial Hashing for Collision Detection of Deformable Objects' (2003).
 */
function hashOf(places: Float64Array, vertex: number): number {
  const at = 3 * vertex;
  return mixed(
    Math.imul(places[at], 73856093) ^ Math.imul(places[at + 1], 19349663) ^ Math.imul(places[at + 2], 83492791),
  );
}

function isSamePlace(places: Float64Array, a: number, b: number): boolean {
  return (
    places[3 * a] === places[3 * b] &&
    places[3 * a + 1] === places[3 * b + 1] &&
    places[3 * a + 2] === places[3 * b + 2]
  );
}

/**
 * Averages the unit normals of all vertices at the same position, so that a hull can grow along them without cracks at
 * creases.
 */
export function hullNormals(mesh: TriangleMesh): Float32Array {
  const welded = weld(mesh.positions);
  const sums = new Float32Array(mesh.normals.length);
  for (let vertex = 0; vertex < welded.length; ++vertex) {
    for (let axis = 0; axis < 3; ++axis) sums[3 * welded[vertex] + axis] += mesh.normals[3 * vertex + axis];
  }
  const normals = new Float32Array(mesh.normals.length);
  for (let vertex = 0; vertex < welded.length; ++vertex) {
    const from = 3 * welded[vertex];
    const length = Math.hypot(sums[from], sums[from + 1], sums[from + 2]) || 1;
    for (let axis = 0; axis < 3; ++axis) normals[3 * vertex + axis] = sums[from + axis] / length;
  }
  return normals;
}

/**
 * Finds the faces and the edges of a closed mesh.
 * @throws RangeError if an edge does not join exactly two triangles: an open mesh encloses no volume
 */
export function* extrude(mesh: TriangleMesh): Work<Extrusion> {
  const { positions, corners } = withoutDuplicates(mesh);
  yield;
  const table = new EdgeTable(corners.length);
  for (let corner = 0; corner < corners.length; ++corner) {
    const [start, end] = [corners[corner], corners[nextCorner(corner)]];
    if (table.add(start, end) < corner)
      throw new RangeError(`The edge ${start}>${end} has two faces with the same winding.`);
  }
  yield;
  const edges = new Uint32Array(2 * corners.length);
  let at = 0;
  for (let corner = 0; corner < corners.length; ++corner) {
    const [start, end] = [corners[corner], corners[nextCorner(corner)]];
    const opposite = table.find(end, start);
    if (opposite < 0) throw new RangeError(`The edge ${start}>${end} has one face: the mesh is not closed.`);
    if (start > end) continue;
    edges[at++] = start;
    edges[at++] = end;
    edges[at++] = Math.floor(corner / 3);
    edges[at++] = Math.floor(opposite / 3);
  }
  yield;
  const normals = Float32Array.from(faceNormals(positions, corners));
  normals.forEach((part, axis) => Number.isNaN(part) && (normals[axis] = 0));
  return { positions, corners, normals, edges, longestEdge: longestEdge(positions, corners) };
}

/** The vertices of a mesh, each position once. */
function withoutDuplicates({ positions, indices }: TriangleMesh): Pick<Extrusion, 'positions' | 'corners'> {
  const welded = weld(positions);
  const numbers = new Uint32Array(welded.length);
  const kept = new Float32Array(positions.length);
  let count = 0;
  for (let vertex = 0; vertex < welded.length; ++vertex) {
    numbers[vertex] = welded[vertex] === vertex ? count : numbers[welded[vertex]];
    if (welded[vertex] !== vertex) continue;
    for (let axis = 0; axis < 3; ++axis) kept[3 * count + axis] = positions[3 * vertex + axis];
    ++count;
  }
  return { positions: kept.slice(0, 3 * count), corners: indices.map((vertex) => numbers[vertex]) };
}

/** The next corner of the same triangle. */
export function nextCorner(corner: number): number {
  return corner % 3 < 2 ? corner + 1 : corner - 2;
}

function longestEdge(positions: Float32Array, corners: Uint32Array): number {
  let longest = 0;
  for (let corner = 0; corner < corners.length; ++corner) {
    const [start, end] = [3 * corners[corner], 3 * corners[nextCorner(corner)]];
    const x = positions[end] - positions[start];
    const y = positions[end + 1] - positions[start + 1];
    const z = positions[end + 2] - positions[start + 2];
    // Math.hypot is slow, and few edges are longer than those before.
    if (x * x + y * y + z * z > (1 - 1e-9) * longest * longest) longest = Math.max(longest, Math.hypot(x, y, z));
  }
  return longest;
}

/** xyz of the unit normal of each triangle; NaN for a triangle without area. */
export function faceNormals(positions: Float32Array, corners: Uint32Array): Float64Array {
  const normals = new Float64Array(corners.length);
  for (let first = 0; first < corners.length; first += 3) {
    const [a, b, c] = [3 * corners[first], 3 * corners[first + 1], 3 * corners[first + 2]];
    const ux = positions[b] - positions[a];
    const uy = positions[b + 1] - positions[a + 1];
    const uz = positions[b + 2] - positions[a + 2];
    const vx = positions[c] - positions[a];
    const vy = positions[c + 1] - positions[a + 1];
    const vz = positions[c + 2] - positions[a + 2];
    const [x, y, z] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    const length = Math.hypot(x, y, z);
    const share = length > NO_AREA ? length : NaN;
    normals[first] = x / share;
    normals[first + 1] = y / share;
    normals[first + 2] = z / share;
  }
  return normals;
}

/**
 * Writes the triangles of the shadow volume: faces that face the light, the other faces at the far end, and quads at
 * the silhouette between them (Crow, 'Shadow Algorithms for Computer Graphics', 1977).
 * @param facesLight 1 for each face that faces the light, else 0
 * @param near number of the first vertex at the start of the volume
 * @param far number of the first vertex at its end
 * @param indices where to write, from index `at`; at most 3 for each face and 6 for each edge
 * @returns the index after the last one written
 */
export function writeVolume(
  { corners, edges }: Extrusion,
  facesLight: Uint8Array,
  near: number,
  far: number,
  indices: Uint32Array,
  at: number,
): number {
  for (let corner = 0; corner < corners.length; corner += 3) {
    const first = facesLight[corner / 3] ? near : far;
    indices[at++] = first + corners[corner];
    indices[at++] = first + corners[corner + 1];
    indices[at++] = first + corners[corner + 2];
  }
  for (let edge = 0; edge < edges.length; edge += 4) {
    const isLit = facesLight[edges[edge + 2]];
    if (isLit === facesLight[edges[edge + 3]]) continue;
    const [one, other] = isLit ? [near, far] : [far, near];
    const [start, end] = [edges[edge], edges[edge + 1]];
    indices[at++] = one + end;
    indices[at++] = one + start;
    indices[at++] = other + start;
    indices[at++] = one + end;
    indices[at++] = other + start;
    indices[at++] = other + end;
  }
  return at;
}
