/**
 * What TypeScript needs of the shadow volumes of shaders/lib/volume.glsl: the growth of the bounding ball of a puff, and
 * bounds of the start and the end. tests/visual/renderer/passes/volumes/volumes.spec.ts compares it with the shader and with Rust.
 */
import type { Vector3 } from 'three';
import { CAP_SLACK, NEAREST_LAMP } from '../../base/constants.ts';
import type { PuffExtents } from '../gpu/formTextures.ts';
import type { FrameView } from '../gpu/frameView.ts';

/** Tolerance of the start, radii: rounding in the shader. */
const START_ROUNDING = 0.01;

/**
 * Growth of a volume for each metre along the light, as a share of its size at the centre of the puff.
 * @param distance from the lamp, metres; Infinity for a sun
 * @param ball radius of the bounding ball of the puff, metres
 */
export function growthOf(distance: number, ball: number): number {
  return 1 / Math.max(distance, NEAREST_LAMP * ball);
}

/** Radius at its centre, metres, of the cone of light rays that touch a ball. */
export function radiusOf(ball: number, growth: number): number {
  return ball / Math.sqrt(1 - (growth * ball) ** 2);
}

/** Least and greatest distance between a puff's centre and the start of its volume, in radii, without the shear. */
export function startRange({ capRange }: PuffExtents, minCap: number): [number, number] {
  return [Math.max(capRange[0], minCap), Math.max(capRange[1], minCap)];
}

/**
 * Bound of the distance between a puff's centre and the start of its volume, in radii, with the steepest view ray and the
 * least depth.
 * @param travel unit vector along which the light travels, world space
 * @param minCap least distance behind a puff's centre at which volumes start, in radii
 */
export function latestStart(eye: FrameView, travel: Vector3, extents: PuffExtents, minCap: number): number {
  const { x, y } = travel.clone().transformDirection(eye.uniforms.viewFromWorld.value);
  const tallest = Math.max(1, extents.reach);
  const shear = Math.max(tallest, extents.depth) * eye.steepestSlope + tallest * tallest;
  return startRange(extents, minCap)[1] + CAP_SLACK + START_ROUNDING + Math.hypot(x, y) * shear;
}

/**
 * Whether a puff has its full size, as in shaders/lib/clearance.glsl.
 * @param place of its centre, world space
 * @param radius in metres, of a stretched puff along its stretch
 */
export function hasFullSize({ uniforms }: FrameView, place: Vector3, radius: number): boolean {
  const near = uniforms.near.value;
  const centre = place.clone().applyMatrix4(uniforms.viewFromWorld.value);
  const isPerspective = uniforms.clipFromView.value.elements[11] !== 0;
  return (isPerspective ? centre.length() - near : Math.abs(centre.z + near)) >= 2 * radius;
}

/** Distances along a beam of light, which may widen, at which it enters and leaves a box. */
export class BeamSpan {
  enter = 0;
  exit = 0;
  private readonly aside: readonly number[];

  /** @param aside extent of the beam along each axis, in its radii */
  constructor(aside: readonly number[] = [1, 1, 1]) {
    this.aside = aside;
  }

  /** Whether the beam, in both directions, meets the box. */
  get isMet(): boolean {
    return this.enter <= this.exit;
  }

  /**
   * @param box least x, y and z, and greatest
   * @param places, from where the centre of the puff begins in an array
   * @param travel unit vector along the beam
   * @param radius of the beam at the centre
   * @param spread growth of the radius for each unit of distance
   */
  find(
    box: readonly number[],
    places: ArrayLike<number>,
    from: number,
    travel: readonly number[],
    radius: number,
    spread: number,
  ): void {
    [this.enter, this.exit] = [-Infinity, Infinity];
    for (let axis = 0; axis < 3; axis++) {
      const [place, margin] = [places[from + axis], this.aside[axis] * radius];
      for (let side = 1; side >= -1; side -= 2) {
        const way = side * ((side > 0 ? box[axis + 3] : box[axis]) - place) + margin;
        // Not divided by -0.
        const speed = side * travel[axis] - spread + 0;
        if (speed < 0) this.enter = Math.max(this.enter, way / speed);
        else this.exit = Math.min(this.exit, way / speed);
      }
    }
  }
}
