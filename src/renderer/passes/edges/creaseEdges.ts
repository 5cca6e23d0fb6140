import { faceNormals, nextCorner, weld, type TriangleMesh } from '../extrusion.ts';
import type { Work } from '../../../base/work.ts';
import { EdgeTable } from './edgeTable.ts';

/** Corners between two yields: about a millisecond. */
const CORNERS_PER_STEP = 3000;

/** Edges that are drawn as lines, as flat arrays. */
export interface CreaseEdges {
  count: number;
  /** Six numbers for each edge: its two end points. */
  ends: Float32Array;
  /** Six numbers for each edge: the unit normals of its two faces. A border edge has zeros for the second. */
  faceNormals: Float32Array;
}

/**
 * Finds the creases of a mesh: edges where two faces meet at a sharp angle and do not share vertices, as smooth faces
 * do, and border edges with one face.
 * @param angle least angle between the normals of the two faces, degrees
 */
export function* creaseEdges(mesh: TriangleMesh, angle: number): Work<CreaseEdges> {
  const least = Math.cos((angle * Math.PI) / 180);
  const normals = faceNormals(mesh.positions, mesh.indices);
  yield;
  const edges = yield* edgesOf(mesh, normals);
  const creases: number[] = [];
  for (let edge = 0; edge < edges.count; edge++) {
    const [one, other] = [3 * edges.firstFaces[edge], 3 * edges.secondFaces[edge]];
    if (other < 0 || (edges.isSplit[edge] && dot(normals, one, other) < least)) creases.push(edge);
  }
  const ends = new Float32Array(6 * creases.length);
  const facing = new Float32Array(6 * creases.length);
  creases.forEach((edge, index) => {
    const half = edges.firstHalves[edge];
    for (let axis = 0; axis < 3; axis++) {
      ends[6 * index + axis] = mesh.positions[3 * mesh.indices[half] + axis];
      ends[6 * index + 3 + axis] = mesh.positions[3 * mesh.indices[nextCorner(half)] + axis];
      facing[6 * index + axis] = normals[3 * edges.firstFaces[edge] + axis];
      if (edges.secondFaces[edge] >= 0) facing[6 * index + 3 + axis] = normals[3 * edges.secondFaces[edge] + axis];
    }
  });
  return { count: creases.length, ends, faceNormals: facing };
}

/** The edges between welded vertices, in the order of the triangles. Degenerate triangles have none. */
interface Edges {
  count: number;
  /** The corner at which the first half-edge starts. */
  firstHalves: Uint32Array;
  firstFaces: Uint32Array;
  /** -1 for a border edge. */
  secondFaces: Int32Array;
  /** 1 if the two faces do not share vertices. */
  isSplit: Uint8Array;
}

function* edgesOf({ positions, indices }: TriangleMesh, normals: Float64Array): Work<Edges> {
  const welded = weld(positions);
  const table = new EdgeTable(indices.length);
  const firstHalves = new Uint32Array(indices.length);
  const firstFaces = new Uint32Array(indices.length);
  const secondFaces = new Int32Array(indices.length).fill(-1);
  const isSplit = new Uint8Array(indices.length);
  for (let corner = 0; corner < indices.length; corner++) {
    if (corner % CORNERS_PER_STEP === 0) yield;
    const face = Math.floor(corner / 3);
    if (Number.isNaN(normals[3 * face])) continue;
    const [start, end] = [indices[corner], indices[nextCorner(corner)]];
    const { count } = table;
    const edge = table.add(Math.min(welded[start], welded[end]), Math.max(welded[start], welded[end]));
    if (edge === count) {
      firstHalves[edge] = corner;
      firstFaces[edge] = face;
      continue;
    }
    if (secondFaces[edge] < 0) secondFaces[edge] = face;
    const [one, other] = [indices[firstHalves[edge]], indices[nextCorner(firstHalves[edge])]];
    const isShared = (start === one || start === other) && (end === one || end === other);
    isSplit[edge] = isShared ? 0 : 1;
  }
  return { count: table.count, firstHalves, firstFaces, secondFaces, isSplit };
}

function dot(normals: Float64Array, one: number, other: number): number {
  return normals[one] * normals[other] + normals[one + 1] * normals[other + 1] + normals[one + 2] * normals[other + 2];
}
