import { Box3, Plane, Ray, Sphere, Vector3, type Camera, type Matrix4, type Vector2 } from 'three';
import type { Handle } from '../scenes/scene.ts';

/** Fingers are wider than mice: a grab this many radii from the centre still counts. */
const GRAB_RADII = 1.3;
/** Takes keep places in whole millimetres. A point taken so from the start cannot draw the centre out of its box. */
const PARTS_A_METRE = 1000;

/** Where people want one rigid, by pointers or by steps; everything comes in as numbers, nothing reads the page. */
export class Drag {
  /** Where the centre shall be, within the handle's box. */
  readonly target: Vector3;
  /** The point by which the rigid is held, in its own space. */
  readonly anchor = new Vector3();
  private readonly handle: Handle;
  private readonly box: Box3;
  private readonly plane = new Plane();
  /** From the centre to the anchor, world space. */
  private readonly arm = new Vector3();
  private readonly ray = new Ray();
  private pointer: number | undefined;

  constructor(handle: Handle) {
    this.handle = handle;
    this.target = new Vector3(...handle.start);
    this.box = new Box3(new Vector3(...handle.min), new Vector3(...handle.max));
  }

  /** Whether a pointer holds it. */
  get isHeld(): boolean {
    return this.pointer !== undefined;
  }

  /** Where the anchor shall be, world space. */
  get grip(): Vector3 {
    return this.arm.clone().add(this.target);
  }

  /**
   * Grabs the rigid where the pointer hits it, if it is under the pointer.
   * @param at normalised device coordinates, -1 to 1, y up
   * @param transform of the rigid as it is drawn
   */
  grab(pointer: number, at: Vector2, camera: Camera, transform: Matrix4): boolean {
    this.aim(at, camera);
    const centre = new Vector3().setFromMatrixPosition(transform);
    if (this.isHeld || this.ray.distanceToPoint(centre) > this.handle.radius * GRAB_RADII) return false;
    this.pointer = pointer;
    const hit = this.hitOf(centre);
    this.plane.setFromNormalAndCoplanarPoint(camera.getWorldDirection(new Vector3()), hit);
    this.anchor.copy(hit).applyMatrix4(transform.clone().invert());
    this.anchor.multiplyScalar(PARTS_A_METRE).round().divideScalar(PARTS_A_METRE);
    this.arm.copy(this.anchor).applyMatrix4(transform).sub(centre);
    return true;
  }

  /** Follows the pointer that grabbed, in the plane of the picture through the point where it did. */
  follow(pointer: number, at: Vector2, camera: Camera): boolean {
    if (pointer !== this.pointer) return false;
    this.aim(at, camera);
    const hit = this.ray.intersectPlane(this.plane, new Vector3());
    if (hit) this.moveTo(hit.sub(this.arm));
    return true;
  }

  /** The pointer lets go; whether it was the one that had grabbed. */
  release(pointer: number): boolean {
    if (pointer !== this.pointer) return false;
    this.pointer = undefined;
    return true;
  }

  /** Steps by metres, as arrow keys do. */
  nudge(by: Vector3): void {
    this.moveTo(by.add(this.target));
  }

  private moveTo(place: Vector3): void {
    this.box.clampPoint(place, this.target);
  }

  /** Where the ray meets the rigid, or passes nearest to its centre when it misses it. */
  private hitOf(centre: Vector3): Vector3 {
    const hit = new Vector3();
    return (
      this.ray.intersectSphere(new Sphere(centre, this.handle.radius), hit) ?? this.ray.closestPointToPoint(centre, hit)
    );
  }

  private aim(at: Vector2, camera: Camera): void {
    this.ray.origin.setFromMatrixPosition(camera.matrixWorld);
    this.ray.direction.set(at.x, at.y, 0.5).unproject(camera).sub(this.ray.origin).normalize();
  }
}
