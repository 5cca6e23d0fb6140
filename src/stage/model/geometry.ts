/** The triangles of a model in its first pose, in metres, with what carries each vertex. */
import type { Color } from '../../renderer/gpu/ramps.ts';
import { refuse } from './glb.ts';
import type { ModelFile, Primitive, Skin } from './modelFile.ts';
import { inverted, multiplyMatrices, type Poses } from './pose.ts';

/** Transforms of vertices that more than one node moves, or whose node has no part of its own. */
export interface Row {
  readonly weights: readonly { readonly share: number; readonly node: number; readonly inverse: Float64Array }[];
  /** From the first pose to the file. */
  fromFirst: Float64Array | undefined;
}

/** Triangles of one node with one material, in world space in the first pose. */
export interface Piece {
  readonly node: number;
  readonly color: Color;
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly indices: Uint32Array;
  /** The node that moves each vertex most. */
  readonly movers: Uint16Array;
  /** Index of the row of each vertex, for vertices of skins. */
  readonly rows: Uint16Array | undefined;
  readonly isSkinned: boolean;
}

/** Rows that the textures of all devices have space for, beside those of surfaces. */
const MAX_ROWS = 1_800;
/** Weights are rounded to these fractions; the finest whose combinations have space. */
const FRACTIONS = [64, 32, 16, 8, 4, 2, 1];
const IDENTITY = Float64Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);

/** All triangles of a file. @param colorOf the colour of a primitive */
export function piecesOf(file: ModelFile, poses: Poses, colorOf: (primitive: Primitive) => Color) {
  const { rows, rowsOf } = rowsFor(file, poses);
  const pieces = file.order.flatMap((node) => {
    const { mesh } = file.nodes[node];
    if (mesh === undefined) return [];
    return file.meshes[mesh].flatMap((primitive) =>
      primitive.indices.length > 0 ? [pieceOf(file, poses, node, primitive, colorOf(primitive), rows, rowsOf)] : [],
    );
  });
  return { pieces, rows };
}

/** Reused, because each frame writes every row. */
const blended = new Float64Array(16);
const product = new Float64Array(16);

/** The matrix of a row from the first pose to that of `poses`, and, without `fromFirst`, from the file. */
export function writeRow({ weights, fromFirst }: Row, { matrices }: Poses, into: Float32Array, to: number): void {
  blended.fill(0);
  for (const { share, node, inverse } of weights) {
    multiplyMatrices(matrices.subarray(16 * node, 16 * node + 16), inverse, product);
    for (let part = 0; part < 16; part++) blended[part] += share * product[part];
  }
  if (fromFirst) multiplyMatrices(blended, fromFirst, product);
  into.set(fromFirst ? product : blended, to);
}

/** The row of each vertex of the primitives of each node with a skin. */
type RowsOf = ReadonlyMap<number, ReadonlyMap<Primitive, Uint16Array>>;

function rowsFor(file: ModelFile, poses: Poses): { rows: Row[]; rowsOf: RowsOf } {
  for (const fraction of FRACTIONS) {
    const rows: Row[] = [];
    const known = new Combinations();
    const rowsOf = new Map<number, Map<Primitive, Uint16Array>>();
    const isComplete = skinnedOf(file).every(({ node, primitive }) => {
      const skin = file.nodes[node].skin!;
      const own = new Uint16Array(primitive.positions.length / 3);
      const ofNode = rowsOf.get(node) ?? new Map<Primitive, Uint16Array>();
      rowsOf.set(node, ofNode.set(primitive, own));
      for (let vertex = 0; vertex < own.length; vertex++) {
        own[vertex] = known.numberOf(skin, primitive, vertex, fraction);
        if (own[vertex] === rows.length) rows.push(rowOf(file.skins[skin], known.parts, fraction, poses));
        if (rows.length > MAX_ROWS) return false;
      }
      return true;
    });
    if (isComplete) return { rows, rowsOf };
  }
  return refuse(`its skins have more than ${MAX_ROWS} bones.`);
}

/** Joints with their weights in whole fractions: up to four pairs, heaviest first, which end at a share of 0. */
type Pairs = Int32Array;

/** Numbers the combinations of a skin and pairs in the order in which they are added. */
class Combinations {
  /** The pairs of the last vertex. */
  readonly parts: Pairs = new Int32Array(8);
  private readonly all: { readonly skin: number; readonly parts: Pairs; readonly next: number }[] = [];
  /** The last combination of each hash; `next` leads to the ones before. */
  private readonly latest = new Map<number, number>();

  numberOf(skin: number, { joints, weights }: Primitive, vertex: number, fraction: number): number {
    const { all, latest, parts } = this;
    round(joints!, weights!, vertex, fraction, parts);
    let hash = skin;
    for (let at = 0; at < parts.length; at++) hash = Math.imul(hash, 31) + parts[at];
    const first = latest.get(hash) ?? -1;
    for (let number = first; number >= 0; number = all[number].next)
      if (all[number].skin === skin && isSame(all[number].parts, parts)) return number;
    latest.set(hash, all.length);
    return all.push({ skin, parts: parts.slice(), next: first }) - 1;
  }
}

function isSame(one: Pairs, other: Pairs): boolean {
  for (let at = 0; at < one.length; at++) if (one[at] !== other[at]) return false;
  return true;
}

function skinnedOf({ nodes, order, meshes }: ModelFile): { node: number; primitive: Primitive }[] {
  return order.flatMap((node) => {
    const { mesh, skin } = nodes[node];
    const all = mesh === undefined || skin === undefined ? [] : meshes[mesh];
    return all.filter(({ joints }) => joints).map((primitive) => ({ node, primitive }));
  });
}

/** Writes the joints of a vertex, with shares whose sum is `fraction`. */
function round(joints: Uint32Array, weights: Float32Array, vertex: number, fraction: number, into: Pairs): void {
  let left = fraction;
  for (let part = 0; part < 4; part++) {
    const joint = joints[4 * vertex + part];
    const share = Math.round(fraction * weights[4 * vertex + part]);
    left -= share;
    let at = 2 * part;
    for (; at > 0 && (into[at - 1] < share || (into[at - 1] === share && into[at - 2] > joint)); at -= 2) {
      into[at] = into[at - 2];
      into[at + 1] = into[at - 1];
    }
    into[at] = joint;
    into[at + 1] = share;
  }
  into[1] += left;
  let end = 0;
  for (let at = 0; at < into.length; at += 2) {
    if (into[at + 1] <= 0) continue;
    into.copyWithin(end, at, at + 2);
    end += 2;
  }
  into.fill(0, end);
}

function rowOf({ joints, inverse }: Skin, parts: Pairs, fraction: number, poses: Poses): Row {
  const weights = [];
  for (let at = 0; at < parts.length && parts[at + 1] > 0; at += 2) {
    const joint = parts[at];
    const own = Float64Array.from(inverse.subarray(16 * joint, 16 * joint + 16));
    weights.push({ share: parts[at + 1] / fraction, node: joints[joint], inverse: own });
  }
  const row: Row = { weights, fromFirst: undefined };
  row.fromFirst = inverted(firstMatrix(row, poses));
  return row;
}

function firstMatrix(row: Row, poses: Poses): Float64Array {
  const first = new Float32Array(16);
  writeRow({ ...row, fromFirst: undefined }, poses, first, 0);
  return Float64Array.from(first);
}

function pieceOf(
  file: ModelFile,
  poses: Poses,
  node: number,
  primitive: Primitive,
  color: Color,
  rows: readonly Row[],
  rowsOf: RowsOf,
): Piece {
  const { skin } = file.nodes[node];
  const isSkinned = skin !== undefined && primitive.joints !== undefined;
  const own = poses.matrices.slice(16 * node, 16 * node + 16);
  const count = primitive.positions.length / 3;
  const vertexRows = isSkinned ? rowsOf.get(node)!.get(primitive)! : undefined;
  // The first pose of each row that has an inverse; the others start in the space of the file.
  const firsts = vertexRows
    ? rows.map((row) => transformOf(row.fromFirst ? firstMatrix(row, poses) : IDENTITY))
    : [transformOf(own)];
  const movers = new Uint16Array(count).fill(node);
  const positions = new Float32Array(3 * count);
  const given = primitive.normals;
  const normals = new Float32Array(3 * count);
  for (let vertex = 0; vertex < count; vertex++) {
    const row = vertexRows ? vertexRows[vertex] : 0;
    if (vertexRows) movers[vertex] = rows[row].weights[0].node;
    move(firsts[row].matrix, primitive.positions, positions, 3 * vertex);
    if (!given) continue;
    move(firsts[row].normals, given, normals, 3 * vertex);
    setLength(normals, 3 * vertex);
  }
  if (positions.some((value) => !Number.isFinite(value))) refuse('a vertex has no finite position.');
  const isMirrored = determinant(firsts[vertexRows ? vertexRows[0] : 0].matrix) < 0;
  const indices = isMirrored ? mirrored(primitive.indices) : primitive.indices;
  const piece = { node, color, positions, normals, indices, movers, rows: vertexRows, isSkinned };
  return given ? piece : withFlatNormals(piece);
}

/** A matrix, and that of its normals, which its cofactors transform. */
function transformOf(m: Float64Array): { matrix: Float64Array; normals: Float64Array } {
  const normals = new Float64Array(16);
  const sign = determinant(m) < 0 ? -1 : 1;
  for (let column = 0; column < 3; column++) {
    for (let row = 0; row < 3; row++) {
      const [r, s] = [(row + 1) % 3, (row + 2) % 3];
      const [c, d] = [4 * ((column + 1) % 3), 4 * ((column + 2) % 3)];
      normals[4 * column + row] = sign * (m[c + r] * m[d + s] - m[d + r] * m[c + s]);
    }
  }
  return { matrix: m, normals };
}

/** Writes a point that a matrix moves. */
function move(m: Float64Array, from: Float32Array, into: Float32Array, at: number): void {
  const x = from[at];
  const y = from[at + 1];
  const z = from[at + 2];
  for (let row = 0; row < 3; row++) into[at + row] = m[row] * x + m[4 + row] * y + m[8 + row] * z + m[12 + row];
}

/** Scales a vector to the length 1; +y if it has no length. */
function setLength(vectors: Float32Array, at: number): void {
  const length = Math.sqrt(
    vectors[at] * vectors[at] + vectors[at + 1] * vectors[at + 1] + vectors[at + 2] * vectors[at + 2],
  );
  for (let part = 0; part < 3; part++)
    vectors[at + part] = length > 0 ? vectors[at + part] / length : part === 1 ? 1 : 0;
}

function determinant(m: ArrayLike<number>): number {
  return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[4] * (m[1] * m[10] - m[2] * m[9]) + m[8] * (m[1] * m[6] - m[2] * m[5]);
}

function mirrored(indices: Uint32Array): Uint32Array {
  return indices.map((_, at) => indices[at % 3 === 0 ? at : at % 3 === 1 ? at + 1 : at - 1]);
}

/** Each triangle with vertices of its own, as glTF asks of meshes without normals. */
function withFlatNormals({ positions, indices, movers, rows, ...others }: Piece): Piece {
  const own = new Float32Array(3 * indices.length);
  const normals = new Float32Array(own.length);
  for (let corner = 0; corner < indices.length; corner++) {
    for (let axis = 0; axis < 3; axis++) own[3 * corner + axis] = positions[3 * indices[corner] + axis];
  }
  for (let first = 0; first < own.length; first += 9) {
    const normal = normalOf(own, first / 3, first / 3 + 1, first / 3 + 2);
    for (let corner = first; corner < first + 9; corner += 3) normals.set(normal, corner);
  }
  return {
    ...others,
    positions: own,
    normals,
    indices: indices.map((_, corner) => corner),
    movers: byCorner(movers, indices),
    rows: rows && byCorner(rows, indices),
  };
}

function byCorner(values: Uint16Array, indices: Uint32Array): Uint16Array {
  const found = new Uint16Array(indices.length);
  for (let corner = 0; corner < indices.length; corner++) found[corner] = values[indices[corner]];
  return found;
}

/** Unit normal of a triangle; +y if it has no area. */
export function normalOf(positions: Float32Array, a: number, b: number, c: number): [number, number, number] {
  return normalized(...crossOf(positions, a, b, c));
}

/** The vector with length 1; +y if it has no length. */
export function normalized(x: number, y: number, z: number): [number, number, number] {
  const length = Math.sqrt(x * x + y * y + z * z);
  return length > 0 ? [x / length, y / length, z / length] : [0, 1, 0];
}

/** The cross product of two sides, whose length is twice the area. */
export function crossOf(positions: Float32Array, a: number, b: number, c: number): [number, number, number] {
  const [i, j, k] = [3 * a, 3 * b, 3 * c];
  const [ux, uy] = [positions[j] - positions[i], positions[j + 1] - positions[i + 1]];
  const [vx, vy] = [positions[k] - positions[i], positions[k + 1] - positions[i + 1]];
  const [uz, vz] = [positions[j + 2] - positions[i + 2], positions[k + 2] - positions[i + 2]];
  return [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
}
