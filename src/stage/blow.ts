import { MathUtils, Vector3, type PerspectiveCamera } from 'three';
import type { Blow } from '../sim/input.ts';

/** Somebody blows at a place of the picture, or sweeps across it; lengths in CSS pixels, y down. */
export interface BlowInput {
  x: number;
  y: number;
  /** How far the pointer moved since the last blow, a sixtieth of a second before; 0 blows away from the eye. */
  dx?: number;
  dy?: number;
  /** How far from the pointer the air moves; 56 when left out. */
  radius?: number;
  /** How long the gust lasts, 1/60 to 10 s; 0.4 when left out. */
  seconds?: number;
}

const RADIUS = 56;
const SECONDS = 0.4;
const STEPS_A_SECOND = 60;
/** Metres a second: of a blow that goes straight on, and the most that a sweep can give. */
const STRAIGHT_SPEED = 2.5;
const TOP_SPEED = 8;

/**
 * @param distance from the eye to what the camera looks at, metres: there a pixel is worth what the gust takes it for
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
