/** Copies a mesh into the unit space of a puff, with the normals and colours that billboards are baked from. */
import type { ClosedMesh, PlainMesh } from './closedMesh.ts';
import { middleOf } from '../normals.ts';
import type { Lobe, PixelImage, PuffMesh } from '../shapes.ts';
import { dot, minus, normalized, type Vector } from '../vector.ts';
import type { Work } from '../../../base/work.ts';

/** Cosine of the angle between two triangles above which the edge between them is smooth. */
const SMOOTH_COSINE = 0.5;
/** Triangles in a slice of about two milliseconds. */
const A_SLICE = 2_000;

/**
 * Triangles that share no vertices, all counter-clockwise seen from outside.
 * @param closed what `closedMesh` made of the mesh
 * @param balls that approximate `closed`
 * @param lobes the same in the unit space of the puff
 */
export function* copyingMesh(
  mesh: PlainMesh,
  closed: ClosedMesh,
  balls: readonly Lobe[],
  lobes: readonly Lobe[],
): Work<PuffMesh> {
  const { positions, indices, normals, colors, uvs, texture } = mesh;
  const corners = Uint32Array.from({ length: indices?.length ?? positions.length / 3 }, (_, at) => indices?.[at] ?? at);
  yield;
  // Lobes are rounded to thousandths, so the scale of their sum is exact enough.
  const sizeOf = (all: readonly Lobe[]): number => all.reduce((sum, { radius }) => sum + radius, 0);
  const scale = sizeOf(lobes) / sizeOf(balls) / closed.reach;
  const middle = middleOf(balls).map((at, axis) => closed.middle[axis] + at * closed.reach);
  const placed = Float32Array.from(positions, (at, index) => (at - middle[index % 3]) * scale);
  if (isInsideOut(placed, corners)) reverse(corners);
  yield;
  const faces = yield* findingFaces(placed, corners);
  const shading = yield* normals ? facingOut(normals, faces, corners) : smoothing(closed.vertexOf, faces, corners);
  yield;
  return {
    positions: gathered(placed, 3, corners),
    normals: shading,
    indices: corners.map((_, at) => at),
    ...(colors && { colors: gathered(colors, 3, corners) }),
    ...(uvs && texture && { uvs: gathered(uvs, 2, corners), texture: copied(texture) }),
  };
}

/** Field by field: those of an `ImageData` are getters, which a spread leaves out. */
function copied({ width, height, data }: PixelImage): PixelImage {
  return { width, height, data: data.slice() };
}

/** The values of each corner. */
function gathered(values: ArrayLike<number>, stride: number, corners: Uint32Array): Float32Array {
  const all = new Float32Array(stride * corners.length);
  for (let at = 0; at < all.length; at++) all[at] = values[stride * corners[Math.floor(at / stride)] + (at % stride)];
  return all;
}

/** Whether the volume that the triangles enclose is negative. */
function isInsideOut(positions: Float32Array, corners: Uint32Array): boolean {
  let volume = 0;
  for (let at = 0; at < corners.length; at += 3) {
    const [a, b, c] = [0, 1, 2].map((corner) => vertexAt(positions, corners[at + corner]));
    volume += dot(a, crossed(b, c));
  }
  return volume < 0;
}

function reverse(corners: Uint32Array): void {
  for (let at = 0; at < corners.length; at += 3) [corners[at], corners[at + 1]] = [corners[at + 1], corners[at]];
}

/** The normal of each triangle, as long as twice its area. */
function* findingFaces(positions: Float32Array, corners: Uint32Array): Work<Vector[]> {
  const faces: Vector[] = [];
  for (let at = 0; at < corners.length; at += 3) {
    const [a, b, c] = [0, 1, 2].map((corner) => vertexAt(positions, corners[at + corner]));
    if (faces.push(crossed(minus(b, a), minus(c, a))) % A_SLICE === 0) yield;
  }
  return faces;
}

/** The given normals as unit vectors, on the outer side of each triangle. */
function* facingOut(normals: ArrayLike<number>, faces: readonly Vector[], corners: Uint32Array): Work<Float32Array> {
  const all = new Float32Array(3 * corners.length);
  for (let corner = 0; corner < corners.length; corner++) {
    const face = faces[Math.floor(corner / 3)];
    const given = normalized(vertexAt(normals, corners[corner]));
    const side = dot(given, face) < 0 ? -1 : 1;
    all.set(dot(given, given) > 0 ? given.map((at) => side * at) : normalized(face), 3 * corner);
    if (corner % A_SLICE === A_SLICE - 1) yield;
  }
  return all;
}

/** Normals that are smooth except where triangles meet at a sharp edge. @param vertexOf see {@link ClosedMesh} */
function* smoothing(vertexOf: Uint32Array, faces: readonly Vector[], corners: Uint32Array): Work<Float32Array> {
  const around: number[][] = [];
  corners.forEach((vertex, corner) => (around[vertexOf[vertex]] ??= []).push(Math.floor(corner / 3)));
  yield;
  const units = faces.map(normalized);
  yield;
  const all = new Float32Array(3 * corners.length);
  for (let corner = 0; corner < corners.length; corner++) {
    const own = units[Math.floor(corner / 3)];
    const smooth = around[vertexOf[corners[corner]]].filter((face) => dot(units[face], own) > SMOOTH_COSINE);
    const sum = [0, 1, 2].map((axis) => smooth.reduce((total, face) => total + faces[face][axis], 0));
    all.set(normalized(sum as unknown as Vector), 3 * corner);
    if (corner % A_SLICE === A_SLICE - 1) yield;
  }
  return all;
}

function vertexAt(values: ArrayLike<number>, vertex: number): Vector {
  return [values[3 * vertex], values[3 * vertex + 1], values[3 * vertex + 2]];
}

function crossed([ax, ay, az]: Vector, [bx, by, bz]: Vector): Vector {
  return [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
}
