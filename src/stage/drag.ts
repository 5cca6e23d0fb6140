import { Box3, Plane, Ray, Vector3, type Camera, type Vector2 } from 'three';
import type { Handle } from '../scenes/scene.ts';

/** Fingers are wider than mice: a grab this many radii from the centre still counts. */
const GRAB_RADII = 1.3;

/** Moves one rigid with pointers or by steps; everything comes in as numbers, nothing reads the page. */
export class Drag {
  readonly target: Vector3;
  private readonly handle: Handle;
  private readonly box: Box3;
  private readonly plane = new Plane();
  private readonly offset = new Vector3();
  private readonly ray = new Ray();
  private pointer: number | undefined;

  constructor(handle: Handle) {
    this.handle = handle;
    this.target = new Vector3(...handle.start);
    this.box = new Box3(new Vector3(...handle.min), new Vector3(...handle.max));
  }

  /**
   * Grabs the rigid if it is under the pointer.
   * @param at normalised device coordinates, -1 to 1, y up
   * @param centre where the rigid is now
   */
  grab(pointer: number, at: Vector2, camera: Camera, centre: Vector3): boolean {
    this.aim(at, camera);
    if (this.pointer !== undefined || this.ray.distanceToPoint(centre) > this.handle.radius * GRAB_RADII) return false;
    this.pointer = pointer;
    this.plane.setFromNormalAndCoplanarPoint(camera.getWorldDirection(new Vector3()), centre);
    const hit = this.ray.intersectPlane(this.plane, new Vector3()) ?? centre;
    this.offset.subVectors(centre, hit);
    return true;
  }

  /** Follows the pointer that grabbed, in the plane of the picture through the rigid. */
  follow(pointer: number, at: Vector2, camera: Camera): boolean {
    if (pointer !== this.pointer) return false;
    this.aim(at, camera);
    const hit = this.ray.intersectPlane(this.plane, new Vector3());
    if (hit) this.moveTo(hit.add(this.offset));
    return true;
  }

  /** Lets go; the rigid stays where it is. */
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

  private aim(at: Vector2, camera: Camera): void {
    this.ray.origin.setFromMatrixPosition(camera.matrixWorld);
    this.ray.direction.set(at.x, at.y, 0.5).unproject(camera).sub(this.ray.origin).normalize();
  }
}
