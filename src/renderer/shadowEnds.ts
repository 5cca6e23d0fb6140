/**
 * Finds where shadows may end: behind the last visible receiver. Visible puffs, as left by arrange(eye), are rasterised
 * to a grid; surfaces are represented by their bounding boxes. The grid is perpendicular to the light of a sun. Around a
 * lamp it is the stereographic projection of the directions, in which balls appear as circles.
 */
import { Vector3, type Box3 } from 'three';
import { NEAREST_LAMP } from '../base/constants.ts';
import { BeamSpan, growthOf, radiusOf } from './passes/shadowVolume.ts';
import type { Rows } from '../simulator/rows.ts';

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
  const grid = new Grid();
  const span = new BeamSpan();

  return ({ count, place }, widest, { bodies, reach, boxes }, travel, lamp) => {
    // Puffs around the lamp do not fit on a grid.
    if (!grid.fit(bodies, reach, travel, lamp) && bodies.length > 0) return ends.fill(Infinity);
    for (let row = 0; 4 * row < bodies.length; row++) {
      const ball = reach * bodies[4 * row + 3];
      grid.project(bodies, row, ball);
      grid.raise(grid.depth + ball);
    }
    const limits = boxes.map(({ min, max }) => [...min, ...max]);
    const ray = [...travel];
    for (let row = 0; row < count; row++) {
      const ball = widest * place[4 * row + 3];
      grid.project(place, row, ball);
      const { depth } = grid;
      let end = grid.raise(-Infinity) - depth;
      if (lamp) grid.way.divideScalar(depth).toArray(ray);
      const growth = growthOf(lamp ? depth : Infinity, ball);
      const radius = radiusOf(ball, growth);
      for (const box of limits) {
        span.find(box, place, 4 * row, ray, radius, radius * growth);
        if (span.isMet) end = Math.max(end, span.exit);
      }
      ends[row] = end;
    }
    return ends;
  };
}

/** The grid, and the ball that was projected to it last. */
class Grid {
  /** From the origin of the light to the ball, and the distance along the light. */
  readonly way = new Vector3();
  depth = 0;
  private across = 0;
  private upwards = 0;
  private radius = 0;
  private readonly right = new Vector3();
  private readonly up = new Vector3();
  private readonly travel = new Vector3();
  private lamp: Vector3 | undefined;
  private left = 0;
  private low = 0;
  private perUnit = 0;
  private readonly farthest = new Float32Array(CELLS * CELLS);

  /** Fits it to the bounds of all puffs, and returns whether that is possible. All cells are at -Infinity then. */
  fit(bodies: Float32Array, reach: number, travel: Vector3, lamp: Vector3 | undefined): boolean {
    const side = Math.abs(travel.x) < 0.7 ? new Vector3(1, 0, 0) : new Vector3(0, 1, 0);
    this.travel.copy(travel);
    this.right.crossVectors(side, travel).normalize();
    this.up.crossVectors(this.right, travel);
    this.lamp = lamp;
    this.farthest.fill(-Infinity);
    this.left = this.low = Infinity;
    let [rightmost, high] = [-Infinity, -Infinity];
    for (let row = 0; 4 * row < bodies.length; row++) {
      this.project(bodies, row, reach * bodies[4 * row + 3]);
      this.left = Math.min(this.left, this.across - this.radius);
      this.low = Math.min(this.low, this.upwards - this.radius);
      rightmost = Math.max(rightmost, this.across + this.radius);
      high = Math.max(high, this.upwards + this.radius);
    }
    this.perUnit = CELLS / Math.max(rightmost - this.left, high - this.low);
    return this.perUnit > 0;
  }

  project(places: Float32Array, row: number, ball: number): void {
    const { way, lamp } = this;
    way.fromArray(places, 4 * row);
    if (lamp) way.sub(lamp);
    this.across = way.dot(this.right);
    this.upwards = way.dot(this.up);
    this.depth = way.dot(this.travel);
    this.radius = ball;
    if (!lamp) return;
    const distance = way.length();
    const sine = ball / distance;
    // Tangents of half the angles from the middle of the grid and across the ball.
    const scale = 1 / (distance + this.depth);
    this.across *= scale;
    this.upwards *= scale;
    this.depth = distance;
    const beside = Math.hypot(this.across, this.upwards);
    const half = sine * NEAREST_LAMP < 1 ? sine / (1 + Math.sqrt(1 - sine * sine)) : Infinity;
    this.radius = half * beside < 1 ? (half * (1 + beside * beside)) / (1 - half * beside) : Infinity;
  }

  /** Raises the cells around the ball to at least a depth, and returns the greatest of their depths. */
  raise(least: number): number {
    const { farthest, radius, perUnit } = this;
    const [x, y] = [this.across - this.left, this.upwards - this.low];
    const first = Math.max(0, Math.floor((x - radius) * perUnit));
    const last = Math.min(CELLS - 1, Math.floor((x + radius) * perUnit));
    const lastRow = Math.min(CELLS - 1, Math.floor((y + radius) * perUnit));
    let greatest = -Infinity;
    for (let row = Math.max(0, Math.floor((y - radius) * perUnit)); row <= lastRow; row++) {
      for (let cell = row * CELLS + first; cell <= row * CELLS + last; cell++) {
        if (farthest[cell] < least) farthest[cell] = least;
        if (farthest[cell] > greatest) greatest = farthest[cell];
      }
    }
    return greatest;
  }
}
