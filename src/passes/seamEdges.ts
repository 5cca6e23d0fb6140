import type { CreaseEdges } from './creaseEdges.ts';
import type { TriangleMesh } from './extrusion.ts';

/** Metres from the plane of a face within which a corner lies on it: what stands on something touches it so. */
const TOUCHING = 1e-5;

type Vector = readonly [number, number, number];

interface Face {
  corners: readonly Vector[];
  normal: Vector;
  low: Vector;
  high: Vector;
}

/**
 * The seams of two meshes in one frame: where a face of one goes through a face of the other or ends on it. Faces that
 * lie in one plane have none. Normals are zero: unlike the line of a crease, that of a seam goes on where one of its faces
 * looks away, close to the silhouette that hides it.
 */
export function seamEdges(one: TriangleMesh, other: TriangleMesh): CreaseEdges {
  const others = facesOf(other).sort((a, b) => a.low[0] - b.low[0]);
  const ends: Vector[] = [];
  for (const face of facesOf(one)) {
    for (const beside of others) {
      if (beside.low[0] > face.high[0] + TOUCHING) break;
      const seam = comesNear(face, beside) ? meet(face, beside) : undefined;
      if (seam) ends.push(...seam);
    }
  }
  const flat = new Float32Array(ends.flat());
  return { count: ends.length / 2, ends: flat, faceNormals: new Float32Array(flat.length) };
}

function facesOf({ positions, indices }: TriangleMesh): Face[] {
  const faces: Face[] = [];
  for (let at = 0; at < indices.length; at += 3) {
    const corners = [0, 1, 2].map((corner): Vector => {
      const first = 3 * indices[at + corner];
      return [positions[first], positions[first + 1], positions[first + 2]];
    });
    const [a, b, c] = corners;
    const across = cross(between(a, b), between(a, c));
    const length = Math.hypot(...across);
    if (length < 1e-12) continue;
    const normal: Vector = [across[0] / length, across[1] / length, across[2] / length];
    faces.push({ corners, normal, low: extreme(corners, Math.min), high: extreme(corners, Math.max) });
  }
  return faces;
}

function extreme([a, b, c]: readonly Vector[], of: (...values: number[]) => number): Vector {
  return [of(a[0], b[0], c[0]), of(a[1], b[1], c[1]), of(a[2], b[2], c[2])];
}

function comesNear(a: Face, b: Face): boolean {
  for (let axis = 0; axis < 3; axis++) {
    if (a.low[axis] > b.high[axis] + TOUCHING || b.low[axis] > a.high[axis] + TOUCHING) return false;
  }
  return true;
}

/** The stretch that two faces share on the line where their planes meet. */
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

/** Where the border of a face meets the plane of another. */
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
