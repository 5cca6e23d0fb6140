import type { Vector3, Vector4 } from 'three';
import type { FrameView } from '../../gpu/frameView.ts';
import { END_STEPS } from '../../gpu/drawnRows.ts';
import { BeamSpan, growthOf, radiusOf } from '../shadowVolume.ts';

/** Largest number of balls of a shadow volume. */
const BALLS = 48;
/** Length of a volume that a ball contains, in radii of the volume. */
const STEP = 1.5;
/** End of a shadow that leaves all receivers, in steps. */
const NO_END = 0xffff;

/** Receives a ball in view space, metres: x, y, distance in front of the camera, radius. */
export type AddBall = (x: number, y: number, distance: number, radius: number) => void;

/** Balls that contain the shadow volume of shaders/lib/volume.glsl, one volume at a time. */
export class VolumeBalls {
  private readonly eye: FrameView;
  private readonly reach: number;
  private readonly span = new BeamSpan();
  private readonly receivers: readonly number[];
  /** Distance from a lamp to the farthest corner of the receivers. */
  private readonly farthest: number;
  private place = [0, 0, 0];
  private way = [0, 0, 0];
  private end = 0;
  private radius = 0;
  private spread = 0;

  /** @param reach radius of the bounding sphere of a puff, in puff radii */
  constructor(eye: FrameView, reach: number) {
    this.eye = eye;
    this.reach = reach;
    const { lightInWorld, receiversMin, receiversMax } = eye.uniforms;
    this.receivers = [...receiversMin.value, ...receiversMax.value];
    this.farthest = farthestCorner(lightInWorld.value, receiversMin.value, receiversMax.value);
  }

  /**
   * Selects a volume. Returns false if it is empty.
   * @param x, y, z, radius world place of the caster and its radius, metres
   * @param word word 0 of its attributes
   */
  select(x: number, y: number, z: number, radius: number, word: number): boolean {
    const { lightInWorld, viewFromWorld } = this.eye.uniforms;
    const light = lightInWorld.value;
    let [tx, ty, tz] = [light.w * x - light.x, light.w * y - light.y, light.w * z - light.z];
    const away = Math.sqrt(tx * tx + ty * ty + tz * tz);
    [tx, ty, tz] = [tx / away, ty / away, tz / away];
    const ball = this.reach * radius;
    const growth = growthOf(light.w === 0 ? Infinity : away, ball);
    this.radius = radiusOf(ball, growth);
    this.spread = growth * this.radius;
    this.span.find(this.receivers, [x, y, z], 0, [tx, ty, tz], this.radius, this.spread);
    const end = word >>> 16;
    this.end = Math.min(
      end === NO_END ? Infinity : (end * radius) / END_STEPS,
      this.span.exit,
      light.w === 0 ? Infinity : this.farthest - away,
    );
    const e = viewFromWorld.value.elements;
    this.way = [
      e[0] * tx + e[4] * ty + e[8] * tz,
      e[1] * tx + e[5] * ty + e[9] * tz,
      -(e[2] * tx + e[6] * ty + e[10] * tz),
    ];
    this.place = [
      e[0] * x + e[4] * y + e[8] * z + e[12],
      e[1] * x + e[5] * y + e[9] * z + e[13],
      -(e[2] * x + e[6] * y + e[10] * z + e[14]),
    ];
    return this.end > 0;
  }

  /** Calls back with balls at both ends of the volume. Their convex hull contains it. */
  addEnds(add: AddBall): void {
    this.add(add, 0, this.radius);
    this.add(add, this.end, this.radius + this.spread * this.end);
  }

  /** Calls back with a chain of balls that contains the volume. */
  addChain(add: AddBall): void {
    const { end, radius, spread } = this;
    for (let from = 0; from < end;) {
      const step = Math.min(end - from, Math.max(STEP * (radius + spread * from), end / BALLS));
      this.add(add, from + 0.5 * step, Math.hypot(radius + spread * (from + step), 0.5 * step));
      from += step;
    }
  }

  private add(add: AddBall, along: number, radius: number): void {
    const { place, way } = this;
    add(place[0] + along * way[0], place[1] + along * way[1], place[2] + along * way[2], radius);
  }
}

/** Distance from a point to the farthest corner of a box, where the volumes of a lamp end at the latest. */
export function farthestCorner({ x, y, z }: Vector4, min: Vector3, max: Vector3): number {
  const along = (place: number, low: number, high: number) => Math.max(Math.abs(place - low), Math.abs(place - high));
  return Math.hypot(along(x, min.x, max.x), along(y, min.y, max.y), along(z, min.z, max.z));
}
