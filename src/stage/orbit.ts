import { MathUtils, PerspectiveCamera, Spherical, Vector3 } from 'three';
import type { CameraMove, CameraPose, Scene } from '../scenes/scene.ts';

const LOWEST = MathUtils.degToRad(-5);
const HIGHEST = MathUtils.degToRad(88);
const NEAREST = 0.3;
const FARTHEST = 40;
/** In a narrow window a scene that says nothing of it still gets this many radians from side to side. */
const LEAST_WIDTH = 0.56;

type Shot = Pick<Scene, 'camera' | 'portrait' | 'cameraMove'>;

/**
 * A camera that circles a point; fed with plain numbers, so that it works in a worker. It follows the scene's own move
 * until somebody turns, shifts or zooms it.
 */
export class OrbitCamera {
  readonly camera = new PerspectiveCamera(40, 1, 0.05, 200);
  private readonly target = new Vector3();
  private readonly place = new Spherical();
  private readonly shot: Shot;
  private readonly move: CameraMove | undefined;
  private isTaken = false;
  private seconds = 0;

  constructor(shot: Shot) {
    this.shot = shot;
    this.move = shot.cameraMove;
    this.reset();
  }

  /** What it looks at. */
  get centre(): Vector3 {
    return this.target.clone();
  }

  /** From the eye to the target, metres. */
  get distance(): number {
    return this.place.radius;
  }

  /** About the vertical, radians; 0 looks from +z. */
  get azimuth(): number {
    return this.place.theta;
  }

  /** Turns about the target, radians. */
  orbit(azimuth: number, elevation: number): void {
    this.place.theta += azimuth;
    this.place.phi = MathUtils.clamp(this.place.phi - elevation, Math.PI / 2 - HIGHEST, Math.PI / 2 - LOWEST);
    this.take();
  }

  /** Comes nearer by a factor above 1. */
  zoom(factor: number): void {
    this.place.radius = MathUtils.clamp(this.place.radius / factor, NEAREST, FARTHEST);
    this.take();
  }

  /** Shifts the target along the picture; the height of the view in pixels says how far a pixel goes. */
  pan(x: number, y: number, heightInPixels: number): void {
    const metres =
      (2 * this.place.radius * Math.tan(MathUtils.degToRad(this.camera.fov) / 2)) / Math.max(heightInPixels, 1);
    this.target.addScaledVector(new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 0), -x * metres);
    this.target.addScaledVector(new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 1), y * metres);
    this.take();
  }

  /** Gives the camera back to the scene. */
  reset(): void {
    this.isTaken = false;
    this.goHome();
  }

  /** Looks as another camera of the same scene does. */
  copy(other: OrbitCamera): void {
    this.target.copy(other.target);
    this.place.copy(other.place);
    this.isTaken = other.isTaken;
    this.seconds = other.seconds;
    this.apply();
  }

  /** Goes where the scene wants its camera at a simulated time, unless somebody has taken it. */
  follow(seconds: number): void {
    if (seconds === this.seconds) return;
    this.seconds = seconds;
    if (this.move && !this.isTaken) this.goHome();
  }

  /** @param aspect width by height of the picture */
  setAspect(aspect: number): void {
    const wasPortrait = this.isPortrait;
    this.camera.aspect = aspect;
    if (wasPortrait !== this.isPortrait && !this.isTaken) this.goHome();
    else this.apply();
  }

  private get isPortrait(): boolean {
    return this.camera.aspect < 1;
  }

  private get home(): CameraPose {
    return this.isPortrait ? { ...this.shot.camera, ...this.shot.portrait } : this.shot.camera;
  }

  private take(): void {
    this.isTaken = true;
    this.apply();
  }

  private goHome(): void {
    const { target, azimuth, elevation, distance } = this.home;
    const shift = this.move?.(this.seconds) ?? {};
    this.target.set(...target).add(new Vector3(...(shift.target ?? [0, 0, 0])));
    this.place.set(
      distance * (shift.distance ?? 1),
      Math.PI / 2 - elevation - (shift.elevation ?? 0),
      azimuth + (shift.azimuth ?? 0),
    );
    this.apply();
  }

  private apply(): void {
    const { fieldOfView, leastWidth = LEAST_WIDTH } = this.home;
    const widened = 2 * Math.atan(Math.tan(leastWidth / 2) / this.camera.aspect);
    this.camera.fov = MathUtils.radToDeg(Math.max(fieldOfView, widened));
    this.camera.updateProjectionMatrix();
    this.camera.position.setFromSpherical(this.place).add(this.target);
    this.camera.lookAt(this.target);
    this.camera.updateMatrixWorld();
  }
}
