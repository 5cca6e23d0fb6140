/**
 * Finds where shadows may end: behind the last visible receiver. Visible puffs, as left by arrange(eye), are rasterised
 * to a grid; surfaces are represented by their bounding boxes. The grid is perpendicular to the light of a sun. Around a
 * lamp it is the stereographic projection of the directions, in which balls appear as circles.
 */
import { Vector3, type Box3 } from 'three';
import { NEAREST_LAMP } from '../constants.ts';
import type { Rows } from '../sim/rows.ts';

/** Cells along each side of the grid, chosen so that a cell is about as wide as a puff. */
const CELLS = 40;

/** Everything that shadows can fall on. */
export interface Receivers {
  /** x, y, z and radius of each visible puff. */
  readonly bodies: Float32Array;
  /** Radius of the bounding sphere of the visible parts of a puff, in puff radii. */
  readonly reach: number;
  /** World-space boxes of all other receivers. */
  readonly boxes: readonly Box3[];
}

/**
 * Returns, for each caster, the distance behind its centre at which its shadow has left every receiver, metres;
 * negative if no receiver is behind it. The array is valid until the next call.
 * @param widest radius of the bounding sphere of a puff, in puff radii
 * @param receivers visible puffs and boxes
 * @param travel unit vector along which the light travels, in the middle of the grid
 * @param lamp place of the light, absent for a sun
 */
export type FindEnds = (
  casters: Rows,
  widest: number,
  receivers: Receivers,
  travel: Vector3,
  lamp?: Vector3,
) => Float32Array;

/**
 * Creates the function with its buffers, which are reused between frames.
 * @param capacity maximum number of casters
 */
export function createShadowEnds(capacity: number): FindEnds {
  const ends = new Float32Array(capacity);
  const farthest = new Float32Array(CELLS * CELLS);

  return ({ count, place }, widest, { bodies, reach, boxes }, travel, lamp) => {
    const side = Math.abs(travel.x) < 0.7 ? new Vector3(1, 0, 0) : new Vector3(0, 1, 0);
    const right = side.cross(travel).normalize();
    const up = right.clone().cross(travel);
    const [way, origin] = [new Vector3(), lamp ?? new Vector3()];
    // The ball that was projected last: its centre and radius on the grid, and its depth along the light.
    let [across, upwards, radius, depth] = [0, 0, 0, 0];
    let [left, low, perUnit] = [Infinity, Infinity, 0];

    function project(places: Float32Array, row: number, ball: number): void {
      way.fromArray(places, 4 * row).sub(origin);
      across = way.dot(right);
      upwards = way.dot(up);
      depth = way.dot(travel);
      radius = ball;
      if (!lamp) return;
      const distance = way.length();
      const sine = ball / distance;
      // Tangents of half the angles from the middle of the grid and across the ball.
      const scale = 1 / (distance + depth);
      across *= scale;
      upwards *= scale;
      depth = distance;
      const beside = Math.hypot(across, upwards);
      const half = sine * NEAREST_LAMP < 1 ? sine / (1 + Math.sqrt(1 - sine * sine)) : Infinity;
      radius = half * beside < 1 ? (half * (1 + beside * beside)) / (1 - half * beside) : Infinity;
    }

    /** Calls back for the cells around the projected ball. */
    function forCells(visit: (cell: number) => void): void {
      const [firstColumn, lastColumn] = cellsAround(across - left, radius, perUnit);
      const [firstRow, lastRow] = cellsAround(upwards - low, radius, perUnit);
      for (let j = firstRow; j <= lastRow; j++) {
        for (let cell = j * CELLS + firstColumn; cell <= j * CELLS + lastColumn; cell++) visit(cell);
      }
    }

    // Fits the grid to the bounds of all puffs.
    let [rightmost, high] = [-Infinity, -Infinity];
    for (let row = 0; 4 * row < bodies.length; row++) {
      project(bodies, row, reach * bodies[4 * row + 3]);
      left = Math.min(left, across - radius);
      low = Math.min(low, upwards - radius);
      rightmost = Math.max(rightmost, across + radius);
      high = Math.max(high, upwards + radius);
    }
    perUnit = CELLS / Math.max(rightmost - left, high - low);
    // Puffs around the lamp do not fit on a grid.
    if (!(perUnit > 0) && bodies.length > 0) return ends.fill(Infinity);

    farthest.fill(-Infinity);
    for (let row = 0; 4 * row < bodies.length; row++) {
      const ball = reach * bodies[4 * row + 3];
      project(bodies, row, ball);
      forCells((cell) => (farthest[cell] = Math.max(farthest[cell], depth + ball)));
    }
    for (let row = 0; row < count; row++) {
      let end = -Infinity;
      const ball = widest * place[4 * row + 3];
      project(place, row, ball);
      forCells((cell) => (end = Math.max(end, farthest[cell])));
      end -= depth;
      const ray = lamp ? way.divideScalar(depth) : travel;
      const growth = lamp ? 1 / Math.max(depth, NEAREST_LAMP * ball) : 0;
      for (const box of boxes) end = Math.max(end, exitFrom(box, place, row, ball, ray, growth));
      ends[row] = end;
    }
    return ends;
  };
}

/** First and last cell along an axis; the range is empty if the first is after the last. */
function cellsAround(middle: number, radius: number, perUnit: number): [number, number] {
  const at = (position: number) => Math.floor(position * perUnit);
  return [Math.max(0, at(middle - radius)), Math.min(CELLS - 1, at(middle + radius))];
}

/**
 * Distance along the light at which the shadow of a ball leaves a box; -Infinity if it misses the box.
 * @param growth ratio of the growth of the radius to the radius, for each metre
 */
function exitFrom(
  { min, max }: Box3,
  places: Float32Array,
  row: number,
  ball: number,
  travel: Vector3,
  growth: number,
): number {
  let [enter, exit] = [-Infinity, Infinity];
  const radius = ball / Math.sqrt(1 - (ball * growth) ** 2);
  const cut = (way: number, speed: number) => {
    // Not divided by -0.
    const at = way / (speed + 0);
    if (speed < 0) enter = Math.max(enter, at);
    else exit = Math.min(exit, at);
  };
  for (const [index, axis] of (['x', 'y', 'z'] as const).entries()) {
    const place = places[4 * row + index];
    cut(max[axis] + radius - place, travel[axis] - radius * growth);
    cut(place - min[axis] + radius, -travel[axis] - radius * growth);
  }
  return enter <= exit ? exit : -Infinity;
}
