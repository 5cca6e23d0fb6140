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

/** For each vertex the number of the first vertex at the same place: creases split vertices, shapes do not end there. */
export function weld(positions: Float32Array): Uint32Array {
  const first = new Map<string, number>();
  const welded = new Uint32Array(positions.length / 3);
  for (let vertex = 0; vertex < welded.length; ++vertex) {
    const key = [0, 1, 2].map((axis) => Math.round(positions[3 * vertex + axis] * 1e5)).join();
    if (!first.has(key)) first.set(key, vertex);
    welded[vertex] = first.get(key)!;
  }
  return welded;
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
  const edges = new Map<string, [number, number]>();
  for (let face = 0; face < faces; ++face) {
    const corners = [0, 1, 2].map((corner) => mesh.indices[3 * face + corner]);
    // Neighbours must share their corners to the last bit, or pixels fall through the cracks and stay dark.
    const points = corners.map((vertex) => mesh.positions.subarray(3 * welded[vertex], 3 * welded[vertex] + 3));
    const normal = faceNormal(points[0], points[1], points[2]);
    for (let corner = 0; corner < 3; ++corner) {
      positions.set(points[corner], 9 * face + 3 * corner);
      faceNormals.set(normal, 9 * face + 3 * corner);
      const key = `${welded[corners[corner]]}>${welded[corners[(corner + 1) % 3]]}`;
      if (edges.has(key)) throw new RangeError(`The edge ${key} belongs to several faces that wind the same way.`);
      edges.set(key, [3 * face + corner, 3 * face + ((corner + 1) % 3)]);
    }
  }
  const indices = Uint32Array.from([...Array(3 * faces).keys(), ...strips(edges)]);
  return { positions, faceNormals, indices, longestEdge: longestEdge(positions) };
}

/** Two triangles for each pair of opposite half-edges. */
function strips(edges: Map<string, [number, number]>): number[] {
  const indices: number[] = [];
  for (const [key, [from, to]] of edges) {
    const [start, end] = key.split('>');
    const opposite = edges.get(`${end}>${start}`);
    if (!opposite) throw new RangeError(`The edge ${key} has a face on one side only: the mesh is not closed.`);
    // The neighbour runs along the same edge the other way: its start lies on our end.
    const [atEnd, atStart] = opposite;
    if (Number(start) < Number(end)) indices.push(to, from, atStart, to, atStart, atEnd);
  }
  return indices;
}

/** @param corners of triangles, nine numbers each */
function longestEdge(corners: Float32Array): number {
  let longest = 0;
  for (let corner = 0; corner < corners.length; corner += 3) {
    const next = corner % 9 < 6 ? corner + 3 : corner - 6;
    const edge = [0, 1, 2].map((axis) => corners[next + axis] - corners[corner + axis]);
    longest = Math.max(longest, Math.hypot(...edge));
  }
  return longest;
}

function faceNormal(a: Float32Array, b: Float32Array, c: Float32Array): [number, number, number] {
  const [ux, uy, uz] = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
  const [vx, vy, vz] = [c[0] - a[0], c[1] - a[1], c[2] - a[2]];
  const [x, y, z] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
  const length = Math.hypot(x, y, z) || 1;
  return [x / length, y / length, z / length];
}
