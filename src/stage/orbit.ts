import { MathUtils, PerspectiveCamera, Spherical, Vector3 } from 'three';
import type { AnyValues, NumberParameter, Values } from '../parameters/parameter.ts';
import { table } from '../parameters/table.ts';
import { requireFinite } from '../parameters/values.ts';
import type { CameraPose, Scene } from '../scenes/scene.ts';

/** Minimum horizontal field of view in a narrow window, radians, for scenes that do not define one. */
const MIN_WIDTH = 0.56;
/** User camera values are rounded, so that a link reproduces exactly the same picture. */
const DECIMALS = { angle: 2, metres: 4 } as const;

type Shot = Pick<Scene, 'camera' | 'portrait' | 'cameraMove'>;

const rows = table.filter((row): row is NumberParameter => row.reader === 'camera');

/** What moves the camera of a running scene. */
interface Viewer {
  readonly picture: { readonly eye: OrbitCamera; readonly size: readonly [width: number, height: number] };
  readonly values: { unset(keys: readonly string[]): void };
  look(move: (eye: OrbitCamera) => void): void;
}

/**
 * Moves the camera and sets the matching `camera.*` values. Redraws while paused.
 * Angles are in radians, lengths in CSS pixels. `reset` returns all camera parameters to the scene.
 */
export function cameraControls(viewer: () => Viewer) {
  return {
    orbit: (azimuth: number, elevation: number) => viewer().look((eye) => eye.orbit(azimuth, elevation)),
    zoom: (factor: number) => viewer().look((eye) => eye.zoom(factor)),
    pan: (x: number, y: number) => viewer().look((eye) => eye.pan(x, y, viewer().picture.size[1])),
    reset: () => viewer().values.unset(Object.keys(viewer().picture.eye.held)),
    /** Angle about the vertical axis; 0 looks from +z. */
    azimuth: () => viewer().picture.eye.azimuth,
  };
}

/**
 * An orbit camera. It takes plain numbers, so it works in a worker. Each camera parameter follows the scene's own
 * camera and movement until the user overrides it by orbiting, panning, zooming, or setting its value.
 */
export class OrbitCamera {
  readonly camera = new PerspectiveCamera(40, 1, 0.05, 200);
  private readonly target = new Vector3();
  private readonly place = new Spherical();
  private readonly shot: Shot;
  private values: AnyValues = {};
  private seconds = 0;
  private height = 1;

  /** @param values whose `camera.*` entries override the scene's camera */
  constructor(shot: Shot, values: Values = {}) {
    this.shot = shot;
    this.override(values);
  }

  /** The target of the camera. */
  get centre(): Vector3 {
    return this.target.clone();
  }

  /** From the camera to the target, metres. */
  get distance(): number {
    return this.place.radius;
  }

  /** Angle about the vertical axis, radians; 0 looks from +z. */
  get azimuth(): number {
    return this.place.theta;
  }

  /** Camera values that override the scene, by parameter key. */
  get held(): Values {
    return this.values;
  }

  /** The scene's own camera at the current time, by every camera parameter key. */
  get wanted(): Values {
    const { target, azimuth, elevation, distance } = this.scenes();
    return rounded({
      ...targetValues(target),
      'camera.azimuth': wrapped(MathUtils.radToDeg(azimuth)),
      'camera.elevation': MathUtils.radToDeg(elevation),
      'camera.distance': distance,
    });
  }

  /** Applies the `camera.*` entries of these values. Omitted ones follow the scene again. */
  override(values: AnyValues): void {
    const given = rows.flatMap(({ key }) => (values[key] === undefined ? [] : [[key, values[key]] as const]));
    this.values = Object.fromEntries(given);
    this.settle();
  }

  /** Rotates about the target, radians. */
  orbit(azimuth: number, elevation: number): void {
    const { theta, phi } = this.place;
    this.adopt({
      'camera.azimuth': wrapped(MathUtils.radToDeg(theta + azimuth)),
      'camera.elevation': 90 - MathUtils.radToDeg(phi - elevation),
    });
  }

  /** A factor above 1 moves the camera closer. */
  zoom(factor: number): void {
    this.adopt({ 'camera.distance': this.place.radius / factor });
  }

  /** Moves the target parallel to the picture, in pixels; the height of the view in pixels sets the scale. */
  pan(x: number, y: number, heightInPixels: number): void {
    const metres = this.metresPerPixel(heightInPixels);
    const right = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 0);
    const up = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 1);
    this.adopt(targetValues(this.centre.addScaledVector(right, -x * metres).addScaledVector(up, y * metres)));
  }

  /** Metres that a pixel spans at the target, in a picture of this height. */
  metresPerPixel(heightInPixels: number): number {
    return (2 * this.place.radius * Math.tan(MathUtils.degToRad(this.camera.fov) / 2)) / Math.max(heightInPixels, 1);
  }

  /** Follows the scene's camera movement to a simulated time, except for overridden parameters. */
  moveTo(seconds: number): void {
    if (seconds === this.seconds) return;
    this.seconds = seconds;
    if (this.shot.cameraMove) this.settle();
  }

  /** @param width, height of the picture in CSS pixels */
  setSize(width: number, height: number): void {
    this.camera.aspect = width / height;
    this.height = height;
    this.settle();
  }

  private get home(): CameraPose {
    const pose = this.camera.aspect < 1 ? { ...this.shot.camera, ...this.shot.portrait } : this.shot.camera;
    if (!pose.pixelsPerMetre) return pose;
    return { ...pose, distance: this.height / pose.pixelsPerMetre / (2 * Math.tan(pose.fieldOfView / 2)) };
  }

  private adopt(values: Record<string, number>): void {
    const taken = rounded(values);
    requireFinite(taken);
    this.values = { ...this.values, ...taken };
    this.settle();
  }

  /** The scene's own camera at the current time; angles in radians. */
  private scenes(): { target: Vector3; azimuth: number; elevation: number; distance: number } {
    const { target, azimuth, elevation, distance } = this.home;
    const shift = this.shot.cameraMove?.(this.seconds) ?? {};
    return {
      target: new Vector3(...target).add(new Vector3(...(shift.target ?? [0, 0, 0]))),
      azimuth: azimuth + (shift.azimuth ?? 0),
      elevation: elevation + (shift.elevation ?? 0),
      distance: distance * (shift.distance ?? 1),
    };
  }

  private settle(): void {
    const { target, azimuth, elevation, distance } = this.scenes();
    const { x, y, z } = target;
    this.target.set(
      this.overriddenValue('target.x') ?? x,
      this.overriddenValue('target.y') ?? y,
      this.overriddenValue('target.z') ?? z,
    );
    this.place.set(
      this.overriddenValue('distance') ?? distance,
      Math.PI / 2 - (this.overriddenAngle('elevation') ?? elevation),
      this.overriddenAngle('azimuth') ?? azimuth,
    );
    this.apply();
  }

  private overriddenValue(name: string): number | undefined {
    return this.values[`camera.${name}`] as number | undefined;
  }

  private overriddenAngle(name: string): number | undefined {
    const degrees = this.overriddenValue(name);
    return degrees === undefined ? undefined : MathUtils.degToRad(degrees);
  }

  private apply(): void {
    const { fieldOfView, minWidth = MIN_WIDTH } = this.home;
    const widened = 2 * Math.atan(Math.tan(minWidth / 2) / this.camera.aspect);
    this.camera.fov = MathUtils.radToDeg(Math.max(fieldOfView, widened));
    this.camera.updateProjectionMatrix();
    this.camera.position.setFromSpherical(this.place).add(this.target);
    this.camera.lookAt(this.target);
    this.camera.updateMatrixWorld();
  }
}

function targetValues({ x, y, z }: Vector3): Record<string, number> {
  return { 'camera.target.x': x, 'camera.target.y': y, 'camera.target.z': z };
}

/** The equivalent angle from -180 up to 180 degrees. */
function wrapped(degrees: number): number {
  return MathUtils.euclideanModulo(degrees + 180, 360) - 180;
}

/** Values clamped to the parameter ranges and rounded. */
function rounded(values: Record<string, number>): Values {
  const taken = rows.filter(({ key }) => values[key] !== undefined);
  return Object.fromEntries(
    taken.map(({ key, unit, min, max }) => {
      const decimals = unit === 'm' ? DECIMALS.metres : DECIMALS.angle;
      // The addition turns -0 into 0: a link does not preserve the sign of zero.
      return [key, Number(MathUtils.clamp(values[key], min, max).toFixed(decimals)) + 0];
    }),
  );
}
