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
  return (
    a[i] <= b[j + 3] + TOUCHING &&
    b[j] <= a[i + 3] + TOUCHING &&
    a[i + 1] <= b[j + 4] + TOUCHING &&
    b[j + 1] <= a[i + 4] + TOUCHING &&
    a[i + 2] <= b[j + 5] + TOUCHING &&
    b[j + 2] <= a[i + 5] + TOUCHING
  );
}

/** The smallest box around some boxes. */
function boxAround(boxes: Float32Array, members: readonly number[]): Float32Array {
  const around = Float32Array.of(Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity);
  for (const member of members) {
    for (let axis = 0; axis < 3; axis++) {
      around[axis] = Math.min(around[axis], boxes[BOX_NUMBERS * member + axis]);
      around[3 + axis] = Math.max(around[3 + axis], boxes[BOX_NUMBERS * member + 3 + axis]);
    }
  }
  return around;
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
    const around = boxAround(boxes, members);
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
