import { MathUtils, PerspectiveCamera, Spherical, Vector3 } from 'three';
import type { CameraPose } from '../scenes/scene.ts';

const LOWEST = MathUtils.degToRad(-5);
const HIGHEST = MathUtils.degToRad(88);
const NEAREST = 0.3;
const FARTHEST = 40;
/** In a narrow window the scene still gets this many radians from side to side. */
const LEAST_WIDTH = 0.56;

/** A camera that circles a point; fed with plain numbers, so that it works in a worker. */
export class OrbitCamera {
  readonly camera = new PerspectiveCamera(40, 1, 0.05, 200);
  private readonly target = new Vector3();
  private readonly place = new Spherical();
  private home: CameraPose;

  constructor(home: CameraPose) {
    this.home = home;
    this.reset();
  }

  /** From the eye to the target, metres. */
  get distance(): number {
    return this.place.radius;
  }

  /** Turns about the target, radians. */
  orbit(azimuth: number, elevation: number): void {
    this.place.theta += azimuth;
    this.place.phi = MathUtils.clamp(this.place.phi - elevation, Math.PI / 2 - HIGHEST, Math.PI / 2 - LOWEST);
    this.apply();
  }

  /** Comes nearer by a factor above 1. */
  zoom(factor: number): void {
    this.place.radius = MathUtils.clamp(this.place.radius / factor, NEAREST, FARTHEST);
    this.apply();
  }

  /** Shifts the target along the picture; the height of the view in pixels says how far a pixel goes. */
  pan(x: number, y: number, heightInPixels: number): void {
    const metres =
      (2 * this.place.radius * Math.tan(MathUtils.degToRad(this.camera.fov) / 2)) / Math.max(heightInPixels, 1);
    this.target.addScaledVector(new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 0), -x * metres);
    this.target.addScaledVector(new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 1), y * metres);
    this.apply();
  }

  /** Goes back to the scene's own view. */
  reset(home = this.home): void {
    this.home = home;
    this.target.set(...home.target);
    this.place.set(home.distance, Math.PI / 2 - home.elevation, home.azimuth);
    this.apply();
  }

  /** @param aspect width by height of the picture */
  setAspect(aspect: number): void {
    this.camera.aspect = aspect;
    this.apply();
  }

  private apply(): void {
    const widened = 2 * Math.atan(Math.tan(LEAST_WIDTH / 2) / this.camera.aspect);
    this.camera.fov = MathUtils.radToDeg(Math.max(this.home.fieldOfView, widened));
    this.camera.updateProjectionMatrix();
    this.camera.position.setFromSpherical(this.place).add(this.target);
    this.camera.lookAt(this.target);
    this.camera.updateMatrixWorld();
  }
}
