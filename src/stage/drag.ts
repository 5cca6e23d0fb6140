import { Box3, Plane, Ray, Sphere, Vector3, type Camera, type Matrix4, type Vector2 } from 'three';
import type { Handle } from '../scenes/scene.ts';
import { POSE_FLOATS } from '../simulator/layout.ts';
import type { Mover, Simulation } from './simulation.ts';

/** A pointer within this many radii of the centre grabs the rigid: fingers are less precise than mice. */
const GRAB_RADII = 1.3;
/**
 * Takes store positions in whole millimetres. Rounding the anchor when it is grabbed keeps the centre inside its box.
 */
const PARTS_A_METRE = 1000;
/** After this many steps, the spring has closed all but 1/10,000 of the distance to the release position. */
const SETTLING_STEPS = 30;

/**
 * Drags the movable rigid of a scene: moves its target by pointers or by steps, and the rigid to its target. Inputs are
 * plain numbers, so it does not access the DOM.
 */
export class Drag implements Mover {
  /** Target position of the centre, within the handle's box. */
  readonly target = new Vector3();
  /** The grabbed point, in the rigid's local space. */
  readonly anchor = new Vector3();
  private readonly simulation: Simulation;
  private readonly handle: Handle;
  private readonly box: Box3;
  private readonly plane = new Plane();
  /** From the centre to the anchor, in world space. */
  private readonly arm = new Vector3();
  private readonly ray = new Ray();
  private pointer: number | undefined;
  /** Step at which the spring releases the rigid; undefined while the spring is inactive. */
  private heldUntil: number | undefined;
  private heldFrom = 0;

  constructor(simulation: Simulation, handle: Handle) {
    this.simulation = simulation;
    this.handle = handle;
    this.box = new Box3(new Vector3(...handle.min), new Vector3(...handle.max));
    simulation.mover = this;
    this.reset();
  }

  /** The rigid while the spring moves it. */
  get heldRigid(): number | undefined {
    return this.heldUntil === undefined ? undefined : this.handle.rigid;
  }

  /** Whether a guide moves the rigid to its target. The guide takes several steps. */
  get isSteered(): boolean {
    return this.handle.steers !== undefined;
  }

  /** World transform of the rigid, as last drawn. */
  get transform(): Matrix4 {
    return this.simulation.matrices[this.handle.rigid];
  }

  /**
   * Grabs the rigid where the pointer hits it, if it is under the pointer.
   * @param at normalized device coordinates, -1 to 1, y up
   */
  grab(pointer: number, at: Vector2, camera: Camera): boolean {
    const { transform } = this;
    this.aim(at, camera);
    const centre = new Vector3().setFromMatrixPosition(transform);
    if (this.pointer !== undefined || this.ray.distanceToPoint(centre) > this.handle.radius * GRAB_RADII) return false;
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
  movePointer(pointer: number, at: Vector2, camera: Camera): boolean {
    if (pointer !== this.pointer) return false;
    this.aim(at, camera);
    const hit = this.ray.intersectPlane(this.plane, new Vector3());
    this.moveTo(hit ? hit.sub(this.arm) : this.target);
    return true;
  }

  /**
   * Releases the rigid.
   * @returns false if another pointer holds it
   */
  release(pointer: number): boolean {
    if (pointer !== this.pointer) return false;
    this.pointer = undefined;
    this.letGo();
    return true;
  }

  /** Moves the target by metres, as the arrow keys do. */
  nudge(by: Vector3): void {
    this.moveTo(by.add(this.target));
    if (this.pointer === undefined) this.letGo();
  }

  /** Moves the target to a position in its box, and the rigid to it: by a spring, or by steering the scene's guide. */
  moveTo(place: Vector3): void {
    this.box.clampPoint(place, this.target);
    if (this.isSteered) return this.steer();
    const [anchor, grip] = [this.anchor.toArray(), this.arm.clone().add(this.target).toArray()];
    this.simulation.input((simulator) => simulator.inputDrag(this.handle.rigid, anchor, grip));
    if (this.heldUntil !== Infinity) this.heldFrom = this.simulation.simulator.steps;
    this.heldUntil = Infinity;
  }

  /**
   * Releases the rigid after it reaches its target, because the target may have been set while paused. A dynamic rigid
   * is released at once if it has been held for at least one step, so that it can be thrown.
   */
  letGo(): void {
    const { simulator, scene } = this.simulation;
    const isThrown = scene.rigids[this.handle.rigid].kind === 'dynamic' && simulator.steps > this.heldFrom;
    if (this.heldUntil === Infinity) this.heldUntil = simulator.steps + (isThrown ? 0 : SETTLING_STEPS);
  }

  /** Releases the rigid when it has settled. */
  beforeStep(): void {
    if (this.heldUntil === undefined || this.simulation.simulator.steps < this.heldUntil) return;
    this.simulation.input((simulator) => simulator.inputRelease(this.handle.rigid));
    this.heldUntil = undefined;
  }

  /** Ends the drag. The target is where the rigid is. */
  reset(): void {
    this.heldUntil = undefined;
    this.pointer = undefined;
    this.anchor.set(0, 0, 0);
    this.arm.set(0, 0, 0);
    this.target.fromArray(this.simulation.simulator.rigidPoses(1), POSE_FLOATS * this.handle.rigid);
  }

  private steer(): void {
    const { min, max, steers } = this.handle;
    const place = this.target.toArray();
    steers!.forEach((channel, axis) => {
      const half = (max[axis] - min[axis]) / 2;
      const value = (place[axis] - min[axis]) / half - 1;
      if (half > 0) this.simulation.input((simulator) => simulator.inputSteer(channel, value));
    });
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
