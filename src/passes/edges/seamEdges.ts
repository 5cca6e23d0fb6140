import { BOX_NUMBERS, boxAround, BoxTree, isNear } from './boxTree.ts';
import type { CreaseEdges } from './creaseEdges.ts';
import type { TriangleMesh } from '../extrusion.ts';
import { memoize } from '../memoize.ts';
import { TOUCHING } from '../../constants.ts';

type Vector = readonly [number, number, number];

interface Face {
  corners: readonly Vector[];
  normal: Vector;
}

/** Some triangles of a mesh, with the first index of each, and their boxes. */
interface Triangles {
  firsts: readonly number[];
  boxes: Float32Array;
}

/**
 * Finds the seams of two meshes in the same space: the segments where faces of one intersect faces of the other or end
 * on them. Coplanar faces have none. Face normals are zero: unlike a crease, a seam is drawn even where one of its
 * faces looks away, close to the silhouette that hides it.
 */
export function seamEdges(one: TriangleMesh, other: TriangleMesh): CreaseEdges {
  const near = trianglesNear(one, memoizedBox(other));
  const others = trianglesNear(other, memoizedBox(one));
  const tree = new BoxTree(others.boxes);
  const faces = others.firsts.map((): Face | undefined => undefined);
  const ends: Vector[] = [];
  near.firsts.forEach((first, index) => {
    const found = tree.near(near.boxes, BOX_NUMBERS * index);
    const face = found.length > 0 ? faceOf(one, first) : undefined;
    if (!face) return;
    for (const number of found) {
      const beside = (faces[number] ??= faceOf(other, others.firsts[number]));
      const seam = beside && meet(face, beside);
      if (seam) ends.push(...seam);
    }
  });
  const flat = new Float32Array(ends.flat());
  return { count: ends.length / 2, ends: flat, faceNormals: new Float32Array(flat.length) };
}

const memoizedBox = memoize(({ positions, indices }: TriangleMesh) => boxAround(positions, indices));

/** Culls triangles outside the box of the other mesh: most meshes of a scene overlap little or not at all. */
function trianglesNear({ positions, indices }: TriangleMesh, box: Float32Array): Triangles {
  const firsts: number[] = [];
  const boxes: number[] = [];
  const own = new Float32Array(BOX_NUMBERS);
  for (let first = 0; first < indices.length; first += 3) {
    boxAround(positions, indices.subarray(first, first + 3), own);
    if (!isNear(own, 0, box, 0)) continue;
    firsts.push(first);
    boxes.push(...own);
  }
  return { firsts, boxes: Float32Array.from(boxes) };
}

function cornerAt(positions: Float32Array, vertex: number): Vector {
  return [positions[3 * vertex], positions[3 * vertex + 1], positions[3 * vertex + 2]];
}

/** A face of a mesh, or undefined if it is degenerate. */
function faceOf({ positions, indices }: TriangleMesh, first: number): Face | undefined {
  const [a, b, c] = [0, 1, 2].map((corner) => cornerAt(positions, indices[first + corner]));
  const [x, y, z] = cross(between(a, b), between(a, c));
  const length = Math.hypot(x, y, z);
  if (length < 1e-12) return undefined;
  return { corners: [a, b, c], normal: [x / length, y / length, z / length] };
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
