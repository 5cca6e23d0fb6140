import { MathUtils, Vector3, type PerspectiveCamera } from 'three';
import type { Blow } from '../simulator/input.ts';

/** A blow at a position in the picture, or a sweep across it. Lengths are in CSS pixels, y points down. */
export interface BlowInput {
  x: number;
  y: number;
  /** Pointer movement since the last blow, 1/60 s earlier; 0 blows away from the camera. */
  dx?: number;
  dy?: number;
  /** Radius of the gust around the pointer. Default: 56. */
  radius?: number;
  /** Duration of the gust, 1/60 to 10 s. Default: 0.4. */
  seconds?: number;
}

const RADIUS = 56;
const SECONDS = 0.4;
const STEPS_A_SECOND = 60;
/** Metres per second: the speed of a blow without a sweep, and the maximum speed of a sweep. */
const STRAIGHT_SPEED = 2.5;
const TOP_SPEED = 8;

/**
 * @param distance from the camera to its target, metres; pixels are converted to metres at this distance
 * @param width, height of the picture in CSS pixels
 */
export function blowOf(
  { x, y, dx = 0, dy = 0, radius = RADIUS, seconds = SECONDS }: BlowInput,
  camera: PerspectiveCamera,
  distance: number,
  width: number,
  height: number,
): Blow {
  const metres = (2 * distance * Math.tan(MathUtils.degToRad(camera.fov) / 2)) / height;
  const origin = new Vector3().setFromMatrixPosition(camera.matrixWorld);
  const ray = new Vector3((x / width) * 2 - 1, 1 - (y / height) * 2, 0.5).unproject(camera).sub(origin).normalize();
  const [right, up] = [0, 1].map((column) => new Vector3().setFromMatrixColumn(camera.matrixWorld, column));
  const sweep = right.multiplyScalar(dx).addScaledVector(up, -dy);
  const velocity =
    sweep.lengthSq() > 0 ? sweep.multiplyScalar(metres * STEPS_A_SECOND) : ray.clone().multiplyScalar(STRAIGHT_SPEED);
  return {
    origin: origin.toArray(),
    ray: ray.toArray(),
    velocity: velocity.clampLength(0, TOP_SPEED).toArray(),
    radius: MathUtils.clamp(radius * metres, 0.01, 10),
    seconds,
  };
}
