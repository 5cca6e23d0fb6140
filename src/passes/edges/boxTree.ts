import { TOUCHING } from '../../constants.ts';

/** Boxes in a flat array: the x, y and z of the least corner, then of the greatest one. */
export const BOX_NUMBERS = 6;

/** A leaf has at most this many boxes, unless all have the same centre. */
const LEAF = 4;

/** A group of boxes: two halves, or a leaf with the numbers of its boxes. */
interface Group {
  /** The box around the group. */
  readonly around: Float32Array;
  readonly halves?: readonly [Group, Group];
  readonly members: readonly number[];
}

/** Whether two boxes touch or overlap. @param i, j where the boxes start in their arrays */
export function isNear(a: Float32Array, i: number, b: Float32Array, j: number): boolean {
  for (let axis = 0; axis < 3; axis++) {
    if (a[i + axis] > b[j + 3 + axis] + TOUCHING || b[j + axis] > a[i + 3 + axis] + TOUCHING) return false;
  }
  return true;
}

/**
 * The smallest box around points.
 * @param points x, y and z of each; the corners of boxes are points, too
 * @param chosen numbers of the points
 * @param box takes the result
 */
export function boxAround(
  points: Float32Array,
  chosen: ArrayLike<number>,
  box = new Float32Array(BOX_NUMBERS),
): Float32Array {
  box.fill(Infinity).fill(-Infinity, 3);
  for (let index = 0; index < chosen.length; index++) {
    for (let axis = 0; axis < 3; axis++) {
      const value = points[3 * chosen[index] + axis];
      if (value < box[axis]) box[axis] = value;
      if (value > box[3 + axis]) box[3 + axis] = value;
    }
  }
  return box;
}

/** Finds boxes near other boxes, by a tree that splits groups in the middle of their longest side. */
export class BoxTree {
  private readonly boxes: Float32Array;
  private readonly root: Group;

  constructor(boxes: Float32Array) {
    this.boxes = boxes;
    this.root = this.group(Array.from({ length: boxes.length / BOX_NUMBERS }, (_, member) => member));
  }

  /** The numbers of the boxes that touch or overlap the box that starts at an index of an array, in ascending order. */
  near(boxes: Float32Array, at: number): number[] {
    const found: number[] = [];
    this.search(this.root, boxes, at, found);
    return found.sort((a, b) => a - b);
  }

  private search({ around, halves, members }: Group, boxes: Float32Array, at: number, found: number[]): void {
    if (!isNear(around, 0, boxes, at)) return;
    for (const half of halves ?? []) this.search(half, boxes, at, found);
    for (const member of members) if (isNear(this.boxes, BOX_NUMBERS * member, boxes, at)) found.push(member);
  }

  private group(members: readonly number[]): Group {
    const { boxes } = this;
    const around = boxAround(boxes, members.flatMap((member) => [2 * member, 2 * member + 1]));
    if (members.length <= LEAF) return { around, members };
    const sides = [0, 1, 2].map((axis) => around[3 + axis] - around[axis]);
    const axis = sides.indexOf(Math.max(...sides));
    const middle = around[axis] + around[3 + axis];
    const [low, high]: [number[], number[]] = [[], []];
    for (const member of members) {
      const at = BOX_NUMBERS * member + axis;
      (boxes[at] + boxes[at + 3] < middle ? low : high).push(member);
    }
    if (low.length * high.length === 0) return { around, members };
    return { around, members: [], halves: [this.group(low), this.group(high)] };
  }
}
