/**
 * Finds where shadows may end: behind the last visible receiver. Visible puffs, as left by arrange(eye), are rasterised
 * to a grid perpendicular to the light; surfaces are represented by their bounding boxes.
 */
import { Vector3, type Box3 } from 'three';
import type { Rows } from '../sim/rows.ts';

/** Cells along each side of the grid, chosen so that a cell is about as wide as a puff. */
const CELLS = 40;

type Triple = readonly [number, number, number];

/** Everything that shadows can fall on. */
export interface Receivers {
  /** x, y, z and radius of each visible puff. */
  readonly bodies: Float32Array;
  /** Radius of the bounding sphere of the visible parts of a puff, in puff radii. */
  readonly reach: number;
  /** World-space boxes of all other receivers. */
  readonly boxes: readonly Box3[];
}

/** Finds the ends of parallel shadows. The buffers are reused between frames. */
export class ShadowEnds {
  private readonly ends: Float32Array;
  private readonly farthest = new Float32Array(CELLS * CELLS);
  private readonly corner: [number, number] = [0, 0];
  private perMetre = 0;
  private right: Triple = [1, 0, 0];
  private up: Triple = [0, 1, 0];
  private travel: Triple = [0, 0, -1];

  /** @param capacity maximum number of casters */
  constructor(capacity: number) {
    this.ends = new Float32Array(capacity);
  }

  /**
   * Returns, for each caster, the distance behind its centre at which its shadow has left every receiver, metres;
   * negative if no receiver is behind it. The array is valid until the next call.
   * @param widest radius of the bounding sphere of a puff, in puff radii
   * @param receivers visible puffs and boxes
   * @param travel unit vector along which the light travels
   */
  find({ count, place }: Rows, widest: number, receivers: Receivers, travel: Vector3): Float32Array {
    this.face(travel);
    this.fill(receivers.bodies, receivers.reach);
    for (let row = 0; row < count; row++) {
      const radius = widest * place[4 * row + 3];
      const depth = at(place, row, this.travel);
      let end = this.farthestWithin(at(place, row, this.right), at(place, row, this.up), radius) - depth;
      for (const box of receivers.boxes) end = Math.max(end, exitFrom(box, place, row, radius, this.travel));
      this.ends[row] = end;
    }
    return this.ends;
  }

  private face(travel: Vector3): void {
    const side = Math.abs(travel.x) < 0.7 ? new Vector3(1, 0, 0) : new Vector3(0, 1, 0);
    const right = side.cross(travel).normalize();
    this.right = right.toArray();
    this.up = right.clone().cross(travel).toArray();
    this.travel = travel.toArray();
  }

  /** Stores in each cell the largest distance along the light that a puff over it reaches. */
  private fill(bodies: Float32Array, reach: number): void {
    this.measure(bodies, reach);
    this.farthest.fill(-Infinity);
    for (let row = 0; 4 * row < bodies.length; row++) {
      const radius = reach * bodies[4 * row + 3];
      const depth = at(bodies, row, this.travel) + radius;
      const [firstColumn, lastColumn] = this.cellsOf(at(bodies, row, this.right), radius, 0);
      const [firstRow, lastRow] = this.cellsOf(at(bodies, row, this.up), radius, 1);
      for (let j = firstRow; j <= lastRow; j++) {
        for (let cell = j * CELLS + firstColumn; cell <= j * CELLS + lastColumn; cell++) {
          if (this.farthest[cell] < depth) this.farthest[cell] = depth;
        }
      }
    }
  }

  /** Fits the grid to the bounds of all puffs. */
  private measure(bodies: Float32Array, reach: number): void {
    let side = 0;
    [this.right, this.up].forEach((axis, index) => {
      let [min, max] = [Infinity, -Infinity];
      for (let row = 0; 4 * row < bodies.length; row++) {
        const [middle, radius] = [at(bodies, row, axis), reach * bodies[4 * row + 3]];
        min = Math.min(min, middle - radius);
        max = Math.max(max, middle + radius);
      }
      this.corner[index] = min;
      side = Math.max(side, max - min);
    });
    this.perMetre = side > 0 ? CELLS / side : 0;
  }

  private farthestWithin(across: number, upwards: number, radius: number): number {
    const [firstColumn, lastColumn] = this.cellsOf(across, radius, 0);
    const [firstRow, lastRow] = this.cellsOf(upwards, radius, 1);
    let farthest = -Infinity;
    for (let j = firstRow; j <= lastRow; j++) {
      for (let cell = j * CELLS + firstColumn; cell <= j * CELLS + lastColumn; cell++) {
        if (this.farthest[cell] > farthest) farthest = this.farthest[cell];
      }
    }
    return farthest;
  }

  /** First and last cell along an axis; the range is empty if the first is after the last. */
  private cellsOf(middle: number, radius: number, axis: 0 | 1): [number, number] {
    const from = Math.floor((middle - radius - this.corner[axis]) * this.perMetre);
    const to = Math.floor((middle + radius - this.corner[axis]) * this.perMetre);
    return [Math.max(0, from), Math.min(CELLS - 1, to)];
  }
}

function at(places: Float32Array, row: number, [x, y, z]: Triple): number {
  return places[4 * row] * x + places[4 * row + 1] * y + places[4 * row + 2] * z;
}

/** Distance along the light at which a sphere leaves a box; -Infinity if it misses the box. */
function exitFrom({ min, max }: Box3, places: Float32Array, row: number, radius: number, travel: Triple): number {
  let [enter, exit] = [-Infinity, Infinity];
  const [low, high] = [min.toArray(), max.toArray()];
  for (let axis = 0; axis < 3; axis++) {
    const place = places[4 * row + axis];
    const [ahead, behind] = [(high[axis] + radius - place) / travel[axis], (low[axis] - radius - place) / travel[axis]];
    if (travel[axis] === 0 && (place > high[axis] + radius || place < low[axis] - radius)) return -Infinity;
    if (travel[axis] === 0) continue;
    enter = Math.max(enter, Math.min(ahead, behind));
    exit = Math.min(exit, Math.max(ahead, behind));
  }
  return enter <= exit ? exit : -Infinity;
}
