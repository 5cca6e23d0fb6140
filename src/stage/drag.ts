import { Box3, Plane, Ray, Sphere, Vector3, type Camera, type Matrix4, type Vector2 } from 'three';
import type { Handle } from '../scenes/scene.ts';

/** A pointer within this many radii of the centre grabs the rigid: fingers are less precise than mice. */
const GRAB_RADII = 1.3;
/**
 * Takes store positions in whole millimetres. Rounding the anchor when it is grabbed keeps the centre inside its box.
 */
const PARTS_A_METRE = 1000;

/**
 * The target of a draggable rigid, moved by pointers or by steps. Inputs are plain numbers, so it does not access the
 * DOM.
 */
export class Drag {
  /** Target position of the centre, within the handle's box. */
  readonly target: Vector3;
  /** The grabbed point, in the rigid's local space. */
  readonly anchor = new Vector3();
  private readonly handle: Handle;
  private readonly box: Box3;
  private readonly plane = new Plane();
  /** From the centre to the anchor, in world space. */
  private readonly arm = new Vector3();
  private readonly ray = new Ray();
  private pointer: number | undefined;

  constructor(handle: Handle) {
    this.handle = handle;
    this.target = new Vector3(...handle.start);
    this.box = new Box3(new Vector3(...handle.min), new Vector3(...handle.max));
  }

  get isHeld(): boolean {
    return this.pointer !== undefined;
  }

  /** Target position of the anchor, in world space. */
  get grip(): Vector3 {
    return this.arm.clone().add(this.target);
  }

  /**
   * Grabs the rigid where the pointer hits it, if it is under the pointer.
   * @param at normalized device coordinates, -1 to 1, y up
   * @param transform of the rigid as drawn
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

  /**
   * Follows the pointer that grabbed the rigid, in the plane through the grabbed point that is parallel to the picture.
   */
  follow(pointer: number, at: Vector2, camera: Camera): boolean {
    if (pointer !== this.pointer) return false;
    this.aim(at, camera);
    const hit = this.ray.intersectPlane(this.plane, new Vector3());
    if (hit) this.moveTo(hit.sub(this.arm));
    return true;
  }

  /**
   * Releases the rigid.
   * @returns false if another pointer holds it
   */
  release(pointer: number): boolean {
    if (pointer !== this.pointer) return false;
    this.pointer = undefined;
    return true;
  }

  /** Moves the target by metres, as the arrow keys do. */
  nudge(by: Vector3): void {
    this.moveTo(by.add(this.target));
  }

  private moveTo(place: Vector3): void {
    this.box.clampPoint(place, this.target);
  }

  /** The intersection of the ray with the rigid, or the point of the ray nearest to its centre if it misses. */
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
