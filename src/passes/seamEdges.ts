import type { CreaseEdges } from './creaseEdges.ts';
import type { TriangleMesh } from './extrusion.ts';
import { memoize } from './memoize.ts';
import { TOUCHING } from '../constants.ts';

type Vector = readonly [number, number, number];

interface Box {
  low: Vector;
  high: Vector;
}

interface Face extends Box {
  corners: readonly Vector[];
  normal: Vector;
}

/**
 * Finds the seams of two meshes in the same space: the segments where faces of one intersect faces of the other or end
 * on them. Coplanar faces have none. Face normals are zero: unlike a crease, a seam is drawn even where one of its
 * faces looks away, close to the silhouette that hides it.
 */
export function seamEdges(one: TriangleMesh, other: TriangleMesh): CreaseEdges {
  const faces = facesNear(one, memoizedBox(other));
  const others = facesNear(other, memoizedBox(one)).sort((a, b) => a.low[0] - b.low[0]);
  const ends: Vector[] = [];
  for (const face of faces) {
    for (const beside of others) {
      if (beside.low[0] > face.high[0] + TOUCHING) break;
      const seam = comesNear(face, beside) ? meet(face, beside) : undefined;
      if (seam) ends.push(...seam);
    }
  }
  const flat = new Float32Array(ends.flat());
  return { count: ends.length / 2, ends: flat, faceNormals: new Float32Array(flat.length) };
}

const memoizedBox = memoize(({ positions }: TriangleMesh): Box => {
  const low: [number, number, number] = [Infinity, Infinity, Infinity];
  const high: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  for (let at = 0; at < positions.length; at++) {
    low[at % 3] = Math.min(low[at % 3], positions[at]);
    high[at % 3] = Math.max(high[at % 3], positions[at]);
  }
  return { low, high };
});

/** Culls faces outside the box of the other mesh: most meshes of a scene overlap little or not at all. */
function facesNear({ positions, indices }: TriangleMesh, box: Box): Face[] {
  const faces: Face[] = [];
  for (let at = 0; at < indices.length; at += 3) {
    if (!isTriangleNear(positions, indices, at, box)) continue;
    const face = faceOf(
      cornerAt(positions, indices[at]),
      cornerAt(positions, indices[at + 1]),
      cornerAt(positions, indices[at + 2]),
    );
    if (face) faces.push(face);
  }
  return faces;
}

function isTriangleNear(positions: Float32Array, indices: Uint32Array, at: number, { low, high }: Box): boolean {
  for (let axis = 0; axis < 3; axis++) {
    const a = positions[3 * indices[at] + axis];
    const b = positions[3 * indices[at + 1] + axis];
    const c = positions[3 * indices[at + 2] + axis];
    if (Math.min(a, b, c) > high[axis] + TOUCHING || low[axis] > Math.max(a, b, c) + TOUCHING) return false;
  }
  return true;
}

function cornerAt(positions: Float32Array, vertex: number): Vector {
  return [positions[3 * vertex], positions[3 * vertex + 1], positions[3 * vertex + 2]];
}

/** The face of three corners, or undefined if it is degenerate. */
function faceOf(a: Vector, b: Vector, c: Vector): Face | undefined {
  const [x, y, z] = cross(between(a, b), between(a, c));
  const length = Math.hypot(x, y, z);
  if (length < 1e-12) return undefined;
  const normal: Vector = [x / length, y / length, z / length];
  return { corners: [a, b, c], normal, low: lowest(a, b, c), high: highest(a, b, c) };
}

function lowest(a: Vector, b: Vector, c: Vector): Vector {
  return [Math.min(a[0], b[0], c[0]), Math.min(a[1], b[1], c[1]), Math.min(a[2], b[2], c[2])];
}

function highest(a: Vector, b: Vector, c: Vector): Vector {
  return [Math.max(a[0], b[0], c[0]), Math.max(a[1], b[1], c[1]), Math.max(a[2], b[2], c[2])];
}

function comesNear(a: Box, b: Box): boolean {
  for (let axis = 0; axis < 3; axis++) {
    if (a.low[axis] > b.high[axis] + TOUCHING || b.low[axis] > a.high[axis] + TOUCHING) return false;
  }
  return true;
}

/** The segment that two faces share on the intersection line of their planes. */
function meet(a: Face, b: Face): [Vector, Vector] | undefined {
  const along = cross(a.normal, b.normal);
  if (Math.hypot(...along) < 1e-6) return undefined;
  const byPlace = (p: Vector, q: Vector): number => dot(along, p) - dot(along, q);
  const [ofA, ofB] = [onPlane(a, b).sort(byPlace), onPlane(b, a).sort(byPlace)];
  if (ofA.length < 2 || ofB.length < 2) return undefined;
  const start = byPlace(ofA[0], ofB[0]) > 0 ? ofA[0] : ofB[0];
  const end = byPlace(ofA.at(-1)!, ofB.at(-1)!) < 0 ? ofA.at(-1)! : ofB.at(-1)!;
  return byPlace(end, start) > 0 && Math.hypot(...between(start, end)) > TOUCHING ? [start, end] : undefined;
}

/** The points where the border of a face meets the plane of another face. */
function onPlane({ corners }: Face, plane: Face): Vector[] {
  const above = corners.map((corner) => dot(plane.normal, between(plane.corners[0], corner)));
  const points = corners.filter((_, corner) => Math.abs(above[corner]) <= TOUCHING);
  for (let corner = 0; corner < 3; corner++) {
    const next = (corner + 1) % 3;
    const isApart = Math.min(Math.abs(above[corner]), Math.abs(above[next])) > TOUCHING;
    if (!isApart || above[corner] > 0 === above[next] > 0) continue;
    const share = above[corner] / (above[corner] - above[next]);
    const step = between(corners[corner], corners[next]);
    points.push([0, 1, 2].map((axis) => corners[corner][axis] + share * step[axis]) as unknown as Vector);
  }
  return points;
}

function between([ax, ay, az]: Vector, [bx, by, bz]: Vector): Vector {
  return [bx - ax, by - ay, bz - az];
}

function cross([ax, ay, az]: Vector, [bx, by, bz]: Vector): Vector {
  return [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
}

function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
