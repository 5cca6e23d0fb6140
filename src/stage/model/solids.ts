/**
 * What stands for triangles that enclose no volume, or that bend: balls and capsules. They collide or cast shadow, so they
 * are found by + - * / and square roots only.
 */
import type { Vector } from '../../scenes/scene.ts';
import type { Quaternion } from '../../simulator/exact/rotation.ts';
import { rotate } from '../../simulator/exact/rotation.ts';
import type { TriangleMesh } from '../../renderer/passes/extrusion.ts';
import { EdgeTable } from '../../renderer/passes/edges/edgeTable.ts';
import { weld } from '../../renderer/passes/extrusion.ts';
import { crossOf } from './geometry.ts';

/** A capsule about the axis y of its own space; without height a ball. */
export interface Capsule {
  readonly position: Vector;
  readonly rotation: Quaternion;
  readonly halfHeight: number;
  readonly radius: number;
}

/** Metres. */
const SHORTEST = 0.002;
/** Steps of the power iteration for the longest axis. */
const ITERATIONS = 24;
/** Cells along the longest side of an open surface, one ball each. */
const CELLS = 8;
/** Radius of these balls in cells, so that they overlap. */
const BALL = 0.75;
/** Places on each side of a triangle where cells are looked for, at most. */
const MOST_PLACES = 32;
/** Vertices around a drawn capsule, and rings in each cap. */
const [AROUND, RINGS] = [10, 3];

/** The capsule that points fit best, with half of them outside. @param points x, y, z of each, at least one */
export function fittedCapsule(points: Float32Array): Capsule {
  const count = points.length / 3;
  const middle = [0, 0, 0];
  for (let at = 0; at < points.length; at++) middle[at % 3] += points[at] / count;
  const axis = longestAxis(points, middle);
  let [low, high, away] = [Infinity, -Infinity, 0];
  for (let first = 0; first < points.length; first += 3) {
    const [x, y, z] = [points[first] - middle[0], points[first + 1] - middle[1], points[first + 2] - middle[2]];
    const along = x * axis[0] + y * axis[1] + z * axis[2];
    low = Math.min(low, along);
    high = Math.max(high, along);
    away += Math.max(0, x * x + y * y + z * z - along * along) / count;
  }
  const half = (high - low) / 2;
  const radius = Math.max(1e-3, Math.min(Math.sqrt(away), Math.max(half, 1e-3)));
  const offset = (low + high) / 2;
  return {
    position: [middle[0] + offset * axis[0], middle[1] + offset * axis[1], middle[2] + offset * axis[2]],
    rotation: fromUp(axis),
    halfHeight: half - radius > SHORTEST ? half - radius : 0,
    radius,
  };
}

function longestAxis(points: Float32Array, middle: readonly number[]): Vector {
  const spread = new Float64Array(9);
  for (let first = 0; first < points.length; first += 3) {
    for (let row = 0; row < 3; row++)
      for (let column = 0; column < 3; column++)
        spread[3 * row + column] += (points[first + row] - middle[row]) * (points[first + column] - middle[column]);
  }
  let axis = [0.3, 1, 0.2];
  for (let step = 0; step < ITERATIONS; step++) {
    const next = [0, 1, 2].map(
      (row) => spread[3 * row] * axis[0] + spread[3 * row + 1] * axis[1] + spread[3 * row + 2] * axis[2],
    );
    const length = Math.sqrt(next[0] * next[0] + next[1] * next[1] + next[2] * next[2]);
    if (!(length > 0)) return [0, 1, 0];
    axis = next.map((part) => part / length);
  }
  return [axis[0], axis[1], axis[2]];
}

/** The rotation from +y to a unit vector. */
function fromUp([x, y, z]: Vector): Quaternion {
  // Half way between both; the axis of half a turn is free.
  const length = Math.sqrt((1 + y) * (1 + y) + z * z + x * x);
  return length < 1e-6 ? [1, 0, 0, 0] : [z / length, 0, -x / length, (1 + y) / length];
}

/** Balls that cover triangles. */
export function coveringBalls({ positions }: TriangleMesh, indices: ArrayLike<number>): Capsule[] {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let corner = 0; corner < indices.length; corner++) {
    for (let axis = 0; axis < 3; axis++) {
      const value = positions[3 * indices[corner] + axis];
      low[axis] = Math.min(low[axis], value);
      high[axis] = Math.max(high[axis], value);
    }
  }
  const cell = Math.max(1e-3, ...[0, 1, 2].map((axis) => (high[axis] - low[axis]) / CELLS));
  const cells = new Map<number, [x: number, y: number, z: number, count: number]>();
  const cellOf = (value: number, axis: number) => Math.min(CELLS - 1, Math.floor((value - low[axis]) / cell));
  const add = (x: number, y: number, z: number) => {
    const number = (cellOf(x, 0) * CELLS + cellOf(y, 1)) * CELLS + cellOf(z, 2);
    const sum = cells.get(number) ?? [0, 0, 0, 0];
    if (sum[3] === 0) cells.set(number, sum);
    sum[0] += x;
    sum[1] += y;
    sum[2] += z;
    sum[3]++;
  };
  for (let first = 0; first + 2 < indices.length; first += 3) {
    const corner = (at: number, axis: number) => positions[3 * indices[first + at] + axis];
    let longest = 0;
    for (let axis = 0; axis < 3; axis++) {
      const [a, b, c] = [corner(0, axis), corner(1, axis), corner(2, axis)];
      longest = Math.max(longest, Math.abs(a - b), Math.abs(b - c), Math.abs(c - a));
    }
    const places = Math.min(MOST_PLACES, 1 + Math.ceil((2 * longest) / cell));
    for (let a = 0; a <= places; a++) {
      for (let b = 0; a + b <= places; b++) {
        const [u, v] = [a / places, b / places];
        const at = (axis: number) => (1 - u - v) * corner(0, axis) + u * corner(1, axis) + v * corner(2, axis);
        add(at(0), at(1), at(2));
      }
    }
  }
  return [...cells.values()].map(([x, y, z, count]) => ({
    position: [x / count, y / count, z / count],
    rotation: [0, 0, 0, 1],
    halfHeight: 0,
    radius: BALL * cell,
  }));
}

/**
 * Capsules as one closed mesh that is inside out: its shadow volume begins behind it, so that what it stands for is not
 * in its shadow.
 */
export function insideOut(capsules: readonly Capsule[]): TriangleMesh {
  const positions: number[] = [];
  const indices: number[] = [];
  for (const capsule of capsules) addCapsule(capsule, positions, indices);
  // Only the renderer's volumes read it, from the faces.
  const normals = new Float32Array(positions.length);
  return { positions: Float32Array.from(positions), normals, indices: Uint32Array.from(indices) };
}

function addCapsule({ position, rotation, halfHeight, radius }: Capsule, positions: number[], indices: number[]): void {
  const first = positions.length / 3;
  const add = (across: number, y: number, turn: number) => {
    const angle = (2 * Math.PI * turn) / AROUND;
    const moved = rotate(rotation, [across * Math.cos(angle), y, across * Math.sin(angle)]);
    positions.push(...position.map((place, axis) => place + moved[axis]));
  };
  const angles = Array.from({ length: RINGS }, (_, ring) => (Math.PI / 2) * (ring / RINGS));
  const ringsOf = (side: number) =>
    angles.map((up) => [radius * Math.cos(up), side * (radius * Math.sin(up) + halfHeight)]);
  // The caps of a ball share their ring.
  const rings = [...ringsOf(-1).toReversed(), ...ringsOf(1).slice(halfHeight > 0 ? 0 : 1)];
  add(0, -radius - halfHeight, 0);
  for (const [across, y] of rings) for (let turn = 0; turn < AROUND; turn++) add(across, y, turn);
  add(0, radius + halfHeight, 0);
  const last = positions.length / 3 - 1;
  const at = (ring: number, turn: number) => first + 1 + AROUND * ring + (turn % AROUND);
  for (let turn = 0; turn < AROUND; turn++) {
    indices.push(first, at(0, turn + 1), at(0, turn), last, at(rings.length - 1, turn), at(rings.length - 1, turn + 1));
    for (let ring = 0; ring + 1 < rings.length; ring++) {
      indices.push(at(ring, turn), at(ring, turn + 1), at(ring + 1, turn));
      indices.push(at(ring, turn + 1), at(ring + 1, turn + 1), at(ring + 1, turn));
    }
  }
}

/** Corners of the triangles of a mesh by what they enclose, three for each triangle, in its order. */
export interface Parts {
  /** Triangles that enclose volumes. */
  readonly closed: Uint32Array;
  /** Connected triangles with borders: each edge has at most two triangles, which wind alike. */
  readonly bordered: Uint32Array;
  /** Corners of `bordered` where an edge without a second triangle begins. */
  readonly borders: Uint32Array;
  /** Connected triangles with other edges. */
  readonly tangled: readonly (readonly number[])[];
}

/** Separates the connected parts of a mesh. Triangles without area are left out. */
export function partsOf({ positions, indices }: Pick<TriangleMesh, 'positions' | 'indices'>): Parts {
  const places = weld(positions);
  const corners = new Uint32Array(indices.length);
  for (let corner = 0; corner < corners.length; corner++) corners[corner] = places[indices[corner]];
  const roots = places.slice();
  const root = (vertex: number) => {
    let at = vertex;
    while (roots[at] !== at) at = roots[at] = roots[roots[at]];
    return at;
  };
  const table = new EdgeTable(corners.length);
  const isTangled = new Uint8Array(places.length);
  const isBordered = new Uint8Array(places.length);
  const twice: number[] = [];
  const add = (start: number, end: number) => {
    const { count } = table;
    if (table.add(start, end) < count) twice.push(start);
  };
  const triangles = withAreas(corners);
  for (const first of triangles) {
    const [a, b, c] = [corners[first], corners[first + 1], corners[first + 2]];
    roots[root(a)] = root(b);
    roots[root(b)] = root(c);
    add(a, b);
    add(b, c);
    add(c, a);
  }
  for (const vertex of twice) isTangled[root(vertex)] = 1;
  const borders: number[] = [];
  for (const first of triangles) {
    for (let corner = first; corner < first + 3; corner++) {
      const end = corners[corner < first + 2 ? corner + 1 : first];
      if (table.find(end, corners[corner]) >= 0) continue;
      isBordered[root(corners[corner])] = 1;
      borders.push(corner);
    }
  }
  const tangled = new Map<number, number[]>();
  const found = { closed: new Uint32Array(corners.length), bordered: new Uint32Array(corners.length) };
  const ends = { closed: 0, bordered: 0 };
  for (const first of triangles) {
    const part = root(corners[first]);
    if (isTangled[part]) {
      const own = tangled.get(part) ?? [];
      if (own.length === 0) tangled.set(part, own);
      own.push(first, first + 1, first + 2);
      continue;
    }
    const kind = isBordered[part] ? 'bordered' : 'closed';
    for (let corner = first; corner < first + 3; corner++) found[kind][ends[kind]++] = corner;
  }
  return {
    closed: found.closed.slice(0, ends.closed),
    bordered: found.bordered.slice(0, ends.bordered),
    borders: Uint32Array.from(borders.filter((corner) => !isTangled[root(corners[corner])])),
    tangled: [...tangled.values()],
  };
}

/** The first corner of each triangle that has three different corners. */
function withAreas(corners: Uint32Array): Uint32Array {
  const found = new Uint32Array(corners.length / 3);
  let count = 0;
  for (let first = 0; first + 2 < corners.length; first += 3) {
    const [a, b, c] = [corners[first], corners[first + 1], corners[first + 2]];
    if (a !== b && b !== c && c !== a) found[count++] = first;
  }
  return found.subarray(0, count);
}

/** The area of triangles, square metres. */
export function areaOf({ positions }: Pick<TriangleMesh, 'positions'>, indices: ArrayLike<number>): number {
  let area = 0;
  for (let first = 0; first + 2 < indices.length; first += 3) {
    const [x, y, z] = crossOf(positions, indices[first], indices[first + 1], indices[first + 2]);
    area += Math.sqrt(x * x + y * y + z * z) / 2;
  }
  return area;
}
