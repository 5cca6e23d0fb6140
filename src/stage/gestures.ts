import { Plane, Ray, Vector3, type Camera, type Matrix4, type Vector2, MathUtils, type PerspectiveCamera } from 'three';
import type { BlowInput, PointerInput } from './contract.ts';
import { Drag } from './drag.ts';
import type { Picture } from './picture.ts';
import type { Simulation } from './simulation.ts';
import type { Blow } from '../simulator/input.ts';

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
function blowOf(
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

/** Applies pointer gestures to the simulation: dragging a rigid, blowing and dropping objects. */
export class Gestures {
  private readonly simulation: Simulation;
  private readonly picture: Picture;
  /** Undefined in a scene without a movable rigid. */
  private readonly drag: Drag | undefined;
  private readonly onMove: () => void;
  private movedWhilePaused = false;

  /** @param onMove called when the target of the movable rigid changes */
  constructor(simulation: Simulation, picture: Picture, onMove: () => void) {
    const { handle } = simulation.scene;
    this.simulation = simulation;
    this.picture = picture;
    this.onMove = onMove;
    this.drag = handle && new Drag(simulation, handle);
  }

  /** Handles a pointer event. Returns 'rigid' while it drags a rigid. */
  pointer({ type, id, x, y }: PointerInput): 'rigid' | null {
    const { drag } = this;
    if (!drag || !this.picture.isVisible) return null;
    const at = this.picture.deviceCoordinates(x, y);
    const { camera } = this.picture.eye;
    if (type === 'down') return drag.grab(id, at, camera) ? 'rigid' : null;
    if (type !== 'move') return drag.release(id) ? 'rigid' : null;
    if (!drag.movePointer(id, at, camera)) return null;
    this.onMove();
    return 'rigid';
  }

  /** Moves the target of the movable rigid, if the scene has one, in metres. A spring pulls the rigid there. */
  nudge(dx: number, dy: number, dz: number): void {
    if (!this.drag) return;
    this.drag.nudge(new Vector3(dx, dy, dz));
    this.onMove();
  }

  /** @throws ParameterError naming the value that is out of range */
  blow(input: BlowInput): void {
    if (!this.picture.isVisible) return;
    const { camera, distance } = this.picture.eye;
    const blow = blowOf(input, camera, distance, ...this.picture.size);
    this.simulation.input((simulator) => simulator.inputBlow(blow));
  }

  /**
   * Drops an object at a position in the picture, in CSS pixels.
   * @returns false if the scene has no objects to drop
   */
  drop(x: number, y: number): boolean {
    if (this.simulation.dropCount === 0 || !this.picture.isVisible) return false;
    const { camera, centre } = this.picture.eye;
    const place = placeBefore(this.picture.deviceCoordinates(x, y), camera, centre);
    this.simulation.drop(place, this.drag?.heldRigid);
    return true;
  }

  /** Whether a guide moves the rigid to its target, which takes several steps. */
  get isSteered(): boolean {
    return this.drag?.isSteered ?? false;
  }

  /** Draws the rigid at its target from now on, although the spring moves it there only in the next steps. */
  showMoved(): void {
    this.movedWhilePaused = true;
  }

  /** Draws the rigid at its simulated position again, after steps or a seek. */
  settle(): void {
    this.movedWhilePaused = false;
  }

  /**
   * World transforms of the rigids as drawn, by index, interpolated between the previous step (0) and the latest (1).
   */
  rigids(blend: number): readonly Matrix4[] {
    const rigids = this.simulation.rigids(blend);
    if (this.movedWhilePaused) this.drag!.transform.setPosition(this.drag!.target);
    return rigids;
  }
}

/**
 * The intersection of the ray through a position in the picture with the plane through a point that faces the camera.
 */
function placeBefore(at: Vector2, camera: Camera, point: Vector3): Vector3 {
  const eye = new Vector3().setFromMatrixPosition(camera.matrixWorld);
  const ray = new Ray(eye, new Vector3(at.x, at.y, 0.5).unproject(camera).sub(eye).normalize());
  const plane = new Plane().setFromNormalAndCoplanarPoint(camera.getWorldDirection(new Vector3()), point);
  return ray.intersectPlane(plane, new Vector3()) ?? point;
}
