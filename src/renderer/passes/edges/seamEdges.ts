import type { Work } from '../../../base/work.ts';
import type { CreaseEdges } from './creaseEdges.ts';
import { inOne, type TriangleMesh } from '../extrusion.ts';
import { memoize } from '../memoize.ts';
import { TOUCHING } from '../../../base/constants.ts';

const NO_EDGES: CreaseEdges = { count: 0, ends: new Float32Array(), faceNormals: new Float32Array() };

/** Faces between two yields: about a millisecond. */
const FACES_PER_STEP = 64;

type Vector = readonly [number, number, number];

interface Face {
  corners: readonly Vector[];
  normal: Vector;
}

/** Boxes in a flat array: the x, y and z of the least corner, then of the greatest one. */
type Boxes = Float32Array;
const BOX_NUMBERS = 6;

/** Some triangles of a mesh. */
interface Triangles {
  /** The first index of each. */
  firsts: readonly number[];
  boxes: Boxes;
}

/**
 * Finds the seams of two meshes in the same space: the segments where faces of one intersect faces of the other or end
 * on them. Coplanar faces have none. Face normals are zero: unlike a crease, a seam is drawn even where one of its
 * faces looks away, close to the silhouette that hides it.
 */
export function* seamEdges(one: TriangleMesh, other: TriangleMesh): Work<CreaseEdges> {
  if (!isNear(memoizedBox(one), 0, memoizedBox(other), 0)) return NO_EDGES;
  const near = trianglesNear(one, memoizedBox(other));
  yield;
  const others = fromLowToHigh(trianglesNear(other, memoizedBox(one)));
  const widest = widestOf(others.boxes);
  const faces: (Face | undefined)[] = [];
  const ends: Vector[] = [];
  for (const [index, first] of near.firsts.entries()) {
    if (index % FACES_PER_STEP === 0) yield;
    const [low, high] = [near.boxes[BOX_NUMBERS * index], near.boxes[BOX_NUMBERS * index + 3]];
    let face: Face | undefined;
    let beside = firstFrom(others.boxes, low - widest - 2 * TOUCHING);
    for (; others.boxes[BOX_NUMBERS * beside] <= high + TOUCHING; beside++) {
      if (!isNear(others.boxes, beside, near.boxes, index)) continue;
      face ??= faceOf(one, first);
      const besideFace = (faces[beside] ??= faceOf(other, others.firsts[beside]));
      if (!face || !besideFace || isOneSided(face, besideFace) || isOneSided(besideFace, face)) continue;
      const seam = meet(face, besideFace);
      if (seam) ends.push(...seam);
    }
  }
  const flat = new Float32Array(ends.flat());
  return { count: ends.length / 2, ends: flat, faceNormals: new Float32Array(flat.length) };
}

/** The smallest box around the vertices of a mesh. */
const memoizedBox = memoize(({ positions }: TriangleMesh): Boxes => {
  const box = new Float32Array(BOX_NUMBERS).fill(Infinity).fill(-Infinity, 3);
  for (let at = 0; at < positions.length; at++) {
    const axis = at % 3;
    if (positions[at] < box[axis]) box[axis] = positions[at];
    if (positions[at] > box[3 + axis]) box[3 + axis] = positions[at];
  }
  return box;
});

/** Whether two boxes touch or overlap. */
function isNear(a: Boxes, i: number, b: Boxes, j: number): boolean {
  for (let axis = 0; axis < 3; axis++) {
    if (a[BOX_NUMBERS * i + axis] > b[BOX_NUMBERS * j + 3 + axis] + TOUCHING) return false;
    if (b[BOX_NUMBERS * j + axis] > a[BOX_NUMBERS * i + 3 + axis] + TOUCHING) return false;
  }
  return true;
}

/** Culls triangles outside the box of the other mesh: most meshes of a scene overlap little or not at all. */
function trianglesNear({ positions, indices }: TriangleMesh, box: Boxes): Triangles {
  const firsts: number[] = [];
  const boxes: number[] = [];
  const own = new Float32Array(BOX_NUMBERS);
  for (let first = 0; first < indices.length; first += 3) {
    for (let axis = 0; axis < 3; axis++) {
      const a = positions[3 * indices[first] + axis];
      const b = positions[3 * indices[first + 1] + axis];
      const c = positions[3 * indices[first + 2] + axis];
      own[axis] = Math.min(a, b, c);
      own[3 + axis] = Math.max(a, b, c);
    }
    if (!isNear(own, 0, box, 0)) continue;
    firsts.push(first);
    for (const side of own) boxes.push(side);
  }
  return { firsts, boxes: Float32Array.from(boxes) };
}

/** Sorts by the least x. */
function fromLowToHigh({ firsts, boxes }: Triangles): Triangles {
  const order = firsts.map((_, index) => index).sort((a, b) => boxes[BOX_NUMBERS * a] - boxes[BOX_NUMBERS * b]);
  const sorted = inOne(order.map((index) => boxes.subarray(BOX_NUMBERS * index, BOX_NUMBERS * (index + 1))));
  return { firsts: order.map((index) => firsts[index]), boxes: sorted };
}

/** Greatest length of boxes along x. */
function widestOf(boxes: Boxes): number {
  let widest = 0;
  for (let at = 0; at < boxes.length; at += BOX_NUMBERS) widest = Math.max(widest, boxes[at + 3] - boxes[at]);
  return widest;
}

/** The number of the first box with at least this x, of boxes in the order of their least x. */
function firstFrom(boxes: Boxes, least: number): number {
  let [low, high] = [0, boxes.length / BOX_NUMBERS];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (boxes[BOX_NUMBERS * middle] < least) low = middle + 1;
    else high = middle;
  }
  return low;
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

/** Whether a face is on one side of the plane of another, as most are: a shortcut of `meet`. */
function isOneSided({ corners }: Face, { corners: [origin], normal }: Face): boolean {
  let [below, above] = [0, 0];
  for (const corner of corners) {
    const height = dot(normal, between(origin, corner));
    if (height > TOUCHING) above++;
    if (height < -TOUCHING) below++;
  }
  return above === 3 || below === 3;
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
