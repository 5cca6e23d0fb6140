import { memoize } from './memoize.ts';
import { PLACES_PER_METRE } from '../constants.ts';

/**
 * A triangle mesh as flat arrays: xyz positions, unit normals, three indices a triangle, counterclockwise front faces.
 */
export interface TriangleMesh {
  positions: Float32Array;
  normals: Float32Array;
  indices: Uint32Array;
}

/**
 * A mesh from which a shadow volume can be extruded. No face shares vertices; each vertex has the normal of its face.
 */
export interface Extrusion {
  positions: Float32Array;
  faceNormals: Float32Array;
  indices: Uint32Array;
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
  const places = Float64Array.from(positions, (value) => Math.round(value * PLACES_PER_METRE));
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
  const [x, y, z] = [places[3 * vertex], places[3 * vertex + 1], places[3 * vertex + 2]];
  const mixed = Math.imul(x, 73856093) ^ Math.imul(y, 19349663) ^ Math.imul(z, 83492791);
  return mixed ^ (mixed >>> 15);
}

function isSamePlace(places: Float64Array, a: number, b: number): boolean {
  for (let axis = 0; axis < 3; ++axis) if (places[3 * a + axis] !== places[3 * b + axis]) return false;
  return true;
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
 * Builds the faces and edge quads of a shadow volume that the vertex shader extrudes (the degenerate-quad form of
 * Crow's volumes, 1977). Where two neighbouring triangles both face the light or both face away, the quad between their
 * copies of the shared edge stays degenerate. At the silhouette it opens into a side of the volume. The mesh does not
 * change when the light moves.
 * @throws RangeError if an edge does not join exactly two triangles: an open mesh encloses no volume
 */
export function extrude(mesh: TriangleMesh): Extrusion {
  const welded = weld(mesh.positions);
  const faces = mesh.indices.length / 3;
  const positions = new Float32Array(9 * faces);
  const faceNormals = new Float32Array(9 * faces);
  /** Vertex indices of the two ends of each half-edge. */
  const edges = new Map<number, readonly [number, number]>();
  for (let face = 0; face < faces; ++face) {
    for (let corner = 0; corner < 3; ++corner) {
      // Neighbours must share bit-identical positions, or pixels in the cracks between them stay dark.
      const start = welded[mesh.indices[3 * face + corner]];
      for (let axis = 0; axis < 3; ++axis) positions[9 * face + 3 * corner + axis] = mesh.positions[3 * start + axis];
      const end = welded[mesh.indices[3 * face + ((corner + 1) % 3)]];
      const key = start * welded.length + end;
      if (edges.has(key)) {
        throw new RangeError(`The edge ${start}>${end} has two faces that wind the same way.`);
      }
      edges.set(key, [3 * face + corner, 3 * face + ((corner + 1) % 3)]);
    }
    writeNormals(positions, faceNormals, 9 * face);
  }
  const indices = Uint32Array.from([...Array(3 * faces).keys(), ...strips(edges, welded.length)]);
  return { positions, faceNormals, indices, longestEdge: longestEdge(positions) };
}

/** Two triangles for each pair of opposite half-edges. The key of a half-edge is start times `vertices` plus end. */
function strips(edges: ReadonlyMap<number, readonly [number, number]>, vertices: number): number[] {
  const indices: number[] = [];
  for (const [key, [from, to]] of edges) {
    const [start, end] = [Math.floor(key / vertices), key % vertices];
    const opposite = edges.get(end * vertices + start);
    if (!opposite) {
      throw new RangeError(`The edge ${start}>${end} has one face: the mesh is not closed.`);
    }
    // The neighbour traverses the edge in the opposite direction: its start is our end.
    const [atEnd, atStart] = opposite;
    if (start < end) indices.push(to, from, atStart, to, atStart, atEnd);
  }
  return indices;
}

/** @param corners nine numbers for each triangle */
function longestEdge(corners: Float32Array): number {
  let longest = 0;
  for (let corner = 0; corner < corners.length; corner += 3) {
    const next = corner % 9 < 6 ? corner + 3 : corner - 6;
    const x = corners[next] - corners[corner];
    const y = corners[next + 1] - corners[corner + 1];
    const z = corners[next + 2] - corners[corner + 2];
    longest = Math.max(longest, Math.hypot(x, y, z));
  }
  return longest;
}

/** Writes the unit normal of the triangle at `first` to each of its corners. */
function writeNormals(corners: Float32Array, normals: Float32Array, first: number): void {
  const side = (to: number, axis: number): number => corners[first + to + axis] - corners[first + axis];
  const [ux, uy, uz] = [side(3, 0), side(3, 1), side(3, 2)];
  const [vx, vy, vz] = [side(6, 0), side(6, 1), side(6, 2)];
  const [x, y, z] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
  const length = Math.hypot(x, y, z) || 1;
  for (let corner = first; corner < first + 9; corner += 3) {
    normals[corner] = x / length;
    normals[corner + 1] = y / length;
    normals[corner + 2] = z / length;
  }
}
