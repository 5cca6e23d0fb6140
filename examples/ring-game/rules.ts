import type { Vector3 } from 'three';

/** A ring that flies straight on. Metres, metres per second, and seconds since the page opened. */
export interface Ring {
  readonly from: Vector3;
  readonly velocity: Vector3;
  readonly start: number;
}

/** A hoop with its centre in the plane of the hoops. One that was just hit is invisible. */
export interface Hoop {
  readonly radius: number;
  readonly mesh: { readonly position: Vector3; readonly visible: boolean };
}

/** The place at which a ring crosses the plane z = depth, or undefined before it does. */
export function crossing({ from, velocity, start }: Ring, depth: number, time: number): Vector3 | undefined {
  const seconds = (depth - from.z) / velocity.z;
  return time - start >= seconds ? from.clone().addScaledVector(velocity, seconds) : undefined;
}

/** The visible hoop that encloses a place in its plane. */
export function hoopAround<T extends Hoop>(place: Vector3, hoops: readonly T[]): T | undefined {
  return hoops.find(({ mesh, radius }) => mesh.visible && mesh.position.distanceTo(place) < radius);
}
