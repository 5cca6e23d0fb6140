import { weld, type TriangleMesh } from './extrusion.ts';

/** Edges that are drawn as lines, as flat arrays. */
export interface CreaseEdges {
  count: number;
  /** Six numbers for each edge: its two end points. */
  ends: Float32Array;
  /** Six numbers for each edge: the unit normals of its two faces. A border edge has zeros for the second. */
  faceNormals: Float32Array;
}

type Vector = readonly [number, number, number];

interface Edge {
  ends: readonly [number, number];
  normals: Vector[];
  isSplit: boolean;
}

/**
 * Finds the creases of a mesh: edges where two faces meet at a sharp angle and do not share vertices, as smooth faces
 * do, and border edges with one face.
 * @param angle least angle between the normals of the two faces, degrees
 */
export function creaseEdges(mesh: TriangleMesh, angle: number): CreaseEdges {
  const least = Math.cos((angle * Math.PI) / 180);
  const creases = [...edgesOf(mesh)].filter(
    ({ normals, isSplit }) => normals.length === 1 || (isSplit && dot(normals[0], normals[1]) < least),
  );
  const place = (vertex: number): number[] => [...mesh.positions.subarray(3 * vertex, 3 * vertex + 3)];
  return {
    count: creases.length,
    ends: new Float32Array(creases.flatMap(({ ends }) => ends.flatMap(place))),
    faceNormals: new Float32Array(creases.flatMap(({ normals: [one, other = [0, 0, 0]] }) => [...one, ...other])),
  };
}

function edgesOf(mesh: TriangleMesh): Iterable<Edge> {
  const welded = weld(mesh.positions);
  const edges = new Map<number, Edge>();
  for (let at = 0; at < mesh.indices.length; at += 3) {
    const corners = [...mesh.indices.subarray(at, at + 3)];
    const normal = normalOf(mesh.positions, corners);
    if (!normal) continue;
    for (let side = 0; side < 3; ++side) {
      const ends = [corners[side], corners[(side + 1) % 3]] as const;
      const [one, other] = [welded[ends[0]], welded[ends[1]]];
      const key = Math.min(one, other) * welded.length + Math.max(one, other);
      const edge = edges.get(key);
      if (!edge) edges.set(key, { ends, normals: [normal], isSplit: true });
      else join(edge, ends, normal);
    }
  }
  return edges.values();
}

function join(edge: Edge, ends: readonly [number, number], normal: Vector): void {
  edge.normals.push(normal);
  edge.isSplit = !ends.every((vertex) => edge.ends.includes(vertex));
}

/** The unit normal of a face, or undefined for a degenerate face. */
function normalOf(positions: Float32Array, [a, b, c]: readonly number[]): Vector | undefined {
  const side = (vertex: number): Vector => [
    positions[3 * vertex] - positions[3 * a],
    positions[3 * vertex + 1] - positions[3 * a + 1],
    positions[3 * vertex + 2] - positions[3 * a + 2],
  ];
  const [u, v] = [side(b), side(c)];
  const cross: Vector = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
  const length = Math.hypot(...cross);
  return length > 1e-12 ? [cross[0] / length, cross[1] / length, cross[2] / length] : undefined;
}

function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
