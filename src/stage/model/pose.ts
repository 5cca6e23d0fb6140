/**
 * Poses of the nodes of a model at a time. Poses reach the simulator, so they are computed by + - * / and square roots only,
 * which give the same bits in every engine: rotations are interpolated by normalised lerp.
 */
import type { Placement, Vector } from '../../scenes/scene.ts';
import { rotate, type Quaternion } from '../../simulator/exact/rotation.ts';
import type { Channel, FileAnimation, FileNode, ModelFile } from './modelFile.ts';

/** Numbers of a translation, a rotation and a scale, and where each begins. */
const TRANSFORM = 10;
const FIRST = { translation: 0, rotation: 3, scale: 7 } as const;
/** Times whose poses are kept: both ends of a step, and the time that is drawn. */
const KEPT = 4;

/** The place of a model: its points are scaled, then turned, then moved. */
export interface Place {
  readonly scale: number;
  readonly rotation: Quaternion;
  readonly position: Vector;
}

/** Poses of all nodes. */
export interface Poses {
  /** Column-major 4 x 4 world matrices by node. */
  readonly matrices: Float64Array;
  /** World rotations by node, without scale and shear. */
  readonly rotations: Float64Array;
}

/** Poses of the nodes over time. */
export class Poser {
  /** Nodes that the animation moves, also by those that carry them. */
  readonly isMoving: readonly boolean[];
  private readonly nodes: readonly FileNode[];
  private readonly order: readonly number[];
  private readonly animation: FileAnimation | undefined;
  private readonly speed: number;
  private readonly place: Place;
  private readonly kept = new Map<number, Poses>();

  /** @param speed seconds of the animation per second */
  constructor({ nodes, order }: ModelFile, animation: FileAnimation | undefined, speed: number, place: Place) {
    this.nodes = nodes;
    this.order = order;
    this.animation = animation;
    this.speed = speed;
    this.place = place;
    this.isMoving = movedBy(animation ? [animation] : [], nodes, order);
  }

  /** @param seconds simulated, at least 0. The result is valid until a few other times were asked for */
  at(seconds: number): Poses {
    const time = this.timeIn(seconds);
    const known = this.kept.get(time);
    if (known) return known;
    const oldest = this.kept.size < KEPT ? undefined : this.kept.keys().next().value!;
    const poses = (oldest !== undefined && this.kept.get(oldest)) || emptyPoses(this.nodes.length);
    if (oldest !== undefined) this.kept.delete(oldest);
    this.kept.set(time, poses);
    this.write(time, poses);
    return poses;
  }

  /** Position and rotation of a node. */
  placement(node: number, seconds: number): Placement {
    const { matrices, rotations } = this.at(seconds);
    const [x, y, z] = matrices.subarray(16 * node + 12, 16 * node + 15);
    const [i, j, k, w] = rotations.subarray(4 * node, 4 * node + 4);
    return { position: [x, y, z], rotation: [i, j, k, w] };
  }

  private timeIn(seconds: number): number {
    const { animation, speed } = this;
    if (!animation || animation.seconds === 0) return 0;
    const time = seconds * speed;
    return time - Math.floor(time / animation.seconds) * animation.seconds;
  }

  private write(time: number, { matrices, rotations }: Poses): void {
    const locals = this.nodes.map(({ rest }) => rest as number[]);
    const animated = new Set<number>();
    for (const channel of this.animation?.channels ?? []) {
      if (!animated.has(channel.node)) locals[channel.node] = [...locals[channel.node]];
      animated.add(channel.node);
      sample(channel, time, locals[channel.node]);
    }
    const { scale, rotation, position } = this.place;
    const root = matrixOf([...position, ...rotation, scale, scale, scale]);
    for (const node of this.order) {
      const { parent, matrix } = this.nodes[node];
      const own = matrix && !animated.has(node) ? matrix : matrixOf(locals[node]);
      const turn = matrix && !animated.has(node) ? rotationOf(matrix) : locals[node].slice(FIRST.rotation, FIRST.scale);
      const carrier = parent < 0 ? root : matrices.subarray(16 * parent, 16 * parent + 16);
      const carried = parent < 0 ? rotation : rotations.subarray(4 * parent, 4 * parent + 4);
      multiplyMatrices(carrier, own, matrices, 16 * node);
      multiplyRotations(carried, turn, rotations, 4 * node);
    }
  }
}

/** Whether each node is moved by an animation, also by a node that carries it. */
export function movedBy(
  animations: readonly FileAnimation[],
  nodes: readonly FileNode[],
  order: readonly number[],
): boolean[] {
  const isMoving = nodes.map(() => false);
  for (const { channels } of animations) for (const { node } of channels) isMoving[node] = true;
  for (const node of order) isMoving[node] ||= nodes[node].parent >= 0 && isMoving[nodes[node].parent];
  return isMoving;
}

function emptyPoses(nodes: number): Poses {
  return { matrices: new Float64Array(16 * nodes), rotations: new Float64Array(4 * nodes) };
}

/** Writes the value of a channel at a time into the ten numbers of its node. */
export function sample({ path, times, values, interpolation }: Channel, time: number, into: number[]): void {
  const size = path === 'rotation' ? 4 : 3;
  const to = FIRST[path];
  const last = times.length - 1;
  const key = keyBefore(times, time);
  const isCubic = interpolation === 'CUBICSPLINE';
  // In a spline, each value is between the tangents of its key.
  const at = (of: number, part: number) => values[isCubic ? size * (3 * of + 1) + part : size * of + part];
  const span = key < last && key >= 0 ? times[key + 1] - times[key] : 0;
  const share = interpolation === 'STEP' || span <= 0 ? 0 : (time - times[key]) / span;
  const from = Math.max(0, key);
  let cosine = 0;
  if (path === 'rotation' && share > 0)
    for (let part = 0; part < 4; part++) cosine += at(from, part) * at(from + 1, part);
  for (let part = 0; part < size; part++) {
    const start = at(from, part);
    if (share === 0) {
      into[to + part] = start;
      continue;
    }
    // The shorter arc. Splines have their own tangents, which belong to the signs of the file.
    const end = !isCubic && cosine < 0 ? -at(from + 1, part) : at(from + 1, part);
    into[to + part] = isCubic
      ? hermite(
          start,
          span * values[size * (3 * from + 2) + part],
          end,
          span * values[size * 3 * (from + 1) + part],
          share,
        )
      : start + (end - start) * share;
  }
  if (path === 'rotation') normalize(into, to);
}

/** The last key at or before a time; -1 before the first. */
function keyBefore(times: Float32Array, time: number): number {
  let [low, high] = [0, times.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

/** Cubic Hermite spline of a value and its tangent at both ends. */
function hermite(start: number, leaving: number, end: number, arriving: number, share: number): number {
  const square = share * share;
  const cube = square * share;
  return (
    (2 * cube - 3 * square + 1) * start +
    (cube - 2 * square + share) * leaving +
    (3 * square - 2 * cube) * end +
    (cube - square) * arriving
  );
}

function normalize(numbers: number[], first: number): void {
  let square = 0;
  for (let part = first; part < first + 4; part++) square += numbers[part] * numbers[part];
  const length = Math.sqrt(square);
  const isUsable = length > 1e-12 && length < Infinity;
  for (let part = 0; part < 4; part++)
    numbers[first + part] = isUsable ? numbers[first + part] / length : part === 3 ? 1 : 0;
}

/** The column-major matrix of ten numbers. */
export function matrixOf(transform: ArrayLike<number>): number[] {
  const [x, y, z, i, j, k, w, a, b, c] = Array.from({ length: TRANSFORM }, (_, part) => transform[part]);
  return [
    a * (1 - 2 * (j * j + k * k)),
    a * (2 * (i * j + k * w)),
    a * (2 * (i * k - j * w)),
    0,
    b * (2 * (i * j - k * w)),
    b * (1 - 2 * (i * i + k * k)),
    b * (2 * (j * k + i * w)),
    0,
    c * (2 * (i * k + j * w)),
    c * (2 * (j * k - i * w)),
    c * (1 - 2 * (i * i + j * j)),
    0,
    x,
    y,
    z,
    1,
  ];
}

/** The product a * b of affine matrices. */
export function multiplyMatrices(a: ArrayLike<number>, b: ArrayLike<number>, into: Float64Array, to = 0): void {
  for (let column = 0; column < 4; column++) {
    const x = b[4 * column];
    const y = b[4 * column + 1];
    const z = b[4 * column + 2];
    const isPlace = column === 3 ? 1 : 0;
    for (let row = 0; row < 3; row++)
      into[to + 4 * column + row] = a[row] * x + a[4 + row] * y + a[8 + row] * z + isPlace * a[12 + row];
    into[to + 4 * column + 3] = isPlace;
  }
}

function multiplyRotations(a: ArrayLike<number>, b: ArrayLike<number>, into: Float64Array, to: number): void {
  const [x, y, z, w] = [a[0], a[1], a[2], a[3]];
  const [i, j, k, l] = [b[0], b[1], b[2], b[3]];
  const product = [
    w * i + x * l + y * k - z * j,
    w * j + y * l + z * i - x * k,
    w * k + z * l + x * j - y * i,
    w * l - x * i - y * j - z * k,
  ];
  normalize(product, 0);
  into.set(product, to);
}

/** The rotation of a matrix without its scale (Shepperd, 'Quaternion from rotation matrix', 1978). */
export function rotationOf(matrix: ArrayLike<number>): number[] {
  const columns = [0, 4, 8].map((first) => {
    const [x, y, z] = [matrix[first], matrix[first + 1], matrix[first + 2]];
    const length = Math.sqrt(x * x + y * y + z * z);
    return length > 0 && length < Infinity ? [x / length, y / length, z / length] : [0, 0, 0];
  });
  const [[a, d, g], [b, e, h], [c, f, i]] = columns;
  const found =
    a + e + i > 0
      ? [h - f, c - g, d - b, 1 + a + e + i]
      : a > e && a > i
        ? [1 + a - e - i, b + d, c + g, h - f]
        : e > i
          ? [b + d, 1 + e - a - i, f + h, c - g]
          : [c + g, f + h, 1 + i - a - e, d - b];
  normalize(found, 0);
  return found;
}

/** The inverse of an affine matrix; undefined if it has none. */
export function inverted(m: ArrayLike<number>): Float64Array | undefined {
  const [a, b, c, d, e, f, g, h, i] = [m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]];
  const [x, y, z] = [e * i - f * h, f * g - d * i, d * h - e * g];
  const determinant = a * x + b * y + c * z;
  const largest = Math.max(...[a, b, c, d, e, f, g, h, i].map(Math.abs));
  if (!(Math.abs(determinant) > 1e-9 * largest * largest * largest)) return undefined;
  const of = (value: number) => value / determinant;
  const inverse = Float64Array.of(
    of(x), of(c * h - b * i), of(b * f - c * e), 0,
    of(y), of(a * i - c * g), of(c * d - a * f), 0,
    of(z), of(b * g - a * h), of(a * e - b * d), 0,
    0, 0, 0, 1,
  ); // prettier-ignore
  for (let row = 0; row < 3; row++)
    inverse[12 + row] = -(inverse[row] * m[12] + inverse[4 + row] * m[13] + inverse[8 + row] * m[14]);
  return inverse;
}

/** A point in the space of a placement. */
export function inSpaceOf({ position, rotation: [x, y, z, w] }: Placement, point: Vector): Vector {
  return rotate([-x, -y, -z, w], [point[0] - position[0], point[1] - position[1], point[2] - position[2]]);
}
