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
    const [x, y, z] = [0, 1, 2].map((part) => points[first + part] - middle[part]);
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
  const add = (place: readonly number[]) => {
    const [i, j, k] = place.map((value, axis) => Math.min(CELLS - 1, Math.floor((value - low[axis]) / cell)));
    const sum = cells.get((i * CELLS + j) * CELLS + k) ?? [0, 0, 0, 0];
    cells.set((i * CELLS + j) * CELLS + k, [sum[0] + place[0], sum[1] + place[1], sum[2] + place[2], sum[3] + 1]);
  };
  for (let first = 0; first + 2 < indices.length; first += 3) {
    const corner = (at: number, axis: number) => positions[3 * indices[first + at] + axis];
    const longest = Math.max(
      ...[0, 1, 2].flatMap((axis) => [0, 1, 2].map((at) => Math.abs(corner(at, axis) - corner((at + 1) % 3, axis)))),
    );
    const places = Math.min(MOST_PLACES, 1 + Math.ceil((2 * longest) / cell));
    for (let a = 0; a <= places; a++) {
      for (let b = 0; a + b <= places; b++) {
        const [u, v] = [a / places, b / places];
        add([0, 1, 2].map((axis) => (1 - u - v) * corner(0, axis) + u * corner(1, axis) + v * corner(2, axis)));
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
  readonly closed: readonly number[];
  /** Connected triangles with borders: each edge has at most two triangles, which wind alike. */
  readonly bordered: readonly number[];
  /** Corners of `bordered` where an edge without a second triangle begins. */
  readonly borders: readonly number[];
  /** Connected triangles with other edges. */
  readonly tangled: readonly (readonly number[])[];
}

/** Separates the connected parts of a mesh. Triangles without area are left out. */
export function partsOf({ positions, indices }: Pick<TriangleMesh, 'positions' | 'indices'>): Parts {
  const places = weld(positions);
  const corners = indices.map((vertex) => places[vertex]);
  const roots = places.slice();
  const root = (vertex: number) => {
    let at = vertex;
    while (roots[at] !== at) at = roots[at] = roots[roots[at]];
    return at;
  };
  const endOf = (corner: number) => corners[corner % 3 < 2 ? corner + 1 : corner - 2];
  const isTriangle = (first: number) => {
    const [a, b, c] = [corners[first], corners[first + 1], corners[first + 2]];
    return a !== b && b !== c && c !== a;
  };
  const table = new EdgeTable(corners.length);
  const tangled = new Uint8Array(places.length);
  const bordered = new Uint8Array(places.length);
  const twice: number[] = [];
  for (let first = 0; first < corners.length; first += 3) {
    if (!isTriangle(first)) continue;
    roots[root(corners[first])] = root(corners[first + 1]);
    roots[root(corners[first + 1])] = root(corners[first + 2]);
    for (let at = first; at < first + 3; at++) {
      const { count } = table;
      if (table.add(corners[at], endOf(at)) < count) twice.push(corners[at]);
    }
  }
  for (const vertex of twice) tangled[root(vertex)] = 1;
  const borders: number[] = [];
  for (let corner = 0; corner < corners.length; corner++) {
    if (!isTriangle(corner - (corner % 3)) || table.find(endOf(corner), corners[corner]) >= 0) continue;
    bordered[root(corners[corner])] = 1;
    borders.push(corner);
  }
  const rest = new Map<number, number[]>();
  const found = { closed: [] as number[], bordered: [] as number[] };
  for (let first = 0; first < corners.length; first += 3) {
    if (!isTriangle(first)) continue;
    const part = root(corners[first]);
    if (tangled[part] && !rest.has(part)) rest.set(part, []);
    const into = rest.get(part) ?? (bordered[part] ? found.bordered : found.closed);
    into.push(first, first + 1, first + 2);
  }
  return {
    ...found,
    borders: borders.filter((corner) => !tangled[root(corners[corner])]),
    tangled: [...rest.values()],
  };
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
