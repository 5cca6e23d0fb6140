import { memoize } from './memoize.ts';

/** A triangle mesh as plain arrays: xyz triples, unit normals, three indices a triangle wound anticlockwise from outside. */
export interface TriangleMesh {
  positions: Float32Array;
  normals: Float32Array;
  indices: Uint32Array;
}

/** What a mesh needs to throw a shadow volume: every face has its own corners, with the face's normal at each. */
export interface Extrusion {
  positions: Float32Array;
  faceNormals: Float32Array;
  indices: Uint32Array;
  longestEdge: number;
}

/** Arrays one after the other. */
export function inOne(arrays: readonly Float32Array[]): Float32Array {
  const result = new Float32Array(arrays.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const array of arrays) {
    result.set(array, at);
    at += array.length;
  }
  return result;
}

/** Vertices are at the same place that are nearer to each other than this share of a metre. */
const PLACES_A_METRE = 1e5;

/** For each vertex the number of the first vertex at the same place: creases split vertices, shapes do not end there. */
export const weld = memoize((positions: Float32Array): Uint32Array => {
  const places = Float64Array.from(positions, (value) => Math.round(value * PLACES_A_METRE));
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

/** After Teschner et al., 'Optimized Spatial Hashing for Collision Detection of Deformable Objects' (2003). */
function hashOf(places: Float64Array, vertex: number): number {
  const [x, y, z] = [places[3 * vertex], places[3 * vertex + 1], places[3 * vertex + 2]];
  const mixed = Math.imul(x, 73856093) ^ Math.imul(y, 19349663) ^ Math.imul(z, 83492791);
  return mixed ^ (mixed >>> 15);
}

function isSamePlace(places: Float64Array, a: number, b: number): boolean {
  for (let axis = 0; axis < 3; ++axis) if (places[3 * a + axis] !== places[3 * b + axis]) return false;
  return true;
}

/** Unit normals averaged over all vertices at the same place, along which a hull can grow without tearing at creases. */
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
 * Faces as two layers that the light can pull apart: triangles stay together where both neighbours look at the light or
 * both look away, and where they differ the strip between their two copies of the shared edge opens into the side of
 * the shadow volume (the degenerate-quad form of Crow's volumes, 1977). Nothing is recomputed when the light moves.
 * @throws RangeError when an edge does not join exactly two triangles: an open mesh has no inside to be dark
 */
export function extrude(mesh: TriangleMesh): Extrusion {
  const welded = weld(mesh.positions);
  const faces = mesh.indices.length / 3;
  const positions = new Float32Array(9 * faces);
  const faceNormals = new Float32Array(9 * faces);
  /** Numbers of the corners at both ends of each half-edge. */
  const edges = new Map<number, readonly [number, number]>();
  for (let face = 0; face < faces; ++face) {
    for (let corner = 0; corner < 3; ++corner) {
      // Neighbours must share their corners to the last bit, or pixels fall through the cracks and stay dark.
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

/** Two triangles for each pair of opposite half-edges, which are known by their start times `vertices` plus their end. */
function strips(edges: ReadonlyMap<number, readonly [number, number]>, vertices: number): number[] {
  const indices: number[] = [];
  for (const [key, [from, to]] of edges) {
    const [start, end] = [Math.floor(key / vertices), key % vertices];
    const opposite = edges.get(end * vertices + start);
    if (!opposite) {
      throw new RangeError(`The edge ${start}>${end} has one face: the mesh is not closed.`);
    }
    // The neighbour runs along the same edge the other way: its start lies on our end.
    const [atEnd, atStart] = opposite;
    if (start < end) indices.push(to, from, atStart, to, atStart, atEnd);
  }
  return indices;
}

/** @param corners of triangles, nine numbers each */
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

/** The unit normal of the triangle at `first`, for each of its corners. */
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
