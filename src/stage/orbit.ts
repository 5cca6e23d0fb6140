import { MathUtils, PerspectiveCamera, Spherical, Vector3 } from 'three';
import type { NumberParameter, Values } from '../preset/parameter.ts';
import { table } from '../preset/table.ts';
import { requireFinite } from '../preset/values.ts';
import type { CameraPose, Scene } from '../scenes/scene.ts';

/** In a narrow window a scene that says nothing of it still gets this many radians from side to side. */
const MIN_WIDTH = 0.56;
/** What is taken is rounded, so that whoever opens a link to it sees the very same picture. */
const DECIMALS = { angle: 2, metres: 4 } as const;

type Shot = Pick<Scene, 'camera' | 'portrait' | 'cameraMove'>;

const rows = table.filter((row): row is NumberParameter => row.reader === 'camera');

/**
 * A camera that circles a point; fed with plain numbers, so that it works in a worker. Each part of where it is follows
 * the scene's own eye and move until somebody takes it, by turning, shifting, zooming, or by a value of the table.
 */
export class OrbitCamera {
  readonly camera = new PerspectiveCamera(40, 1, 0.05, 200);
  private readonly target = new Vector3();
  private readonly place = new Spherical();
  private readonly shot: Shot;
  private values: Values = {};
  private seconds = 0;
  private height = 1;

  /** @param values whose `camera.*` say what somebody has taken */
  constructor(shot: Shot, values: Values = {}) {
    this.shot = shot;
    this.hold(values);
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

  /** What somebody has taken from the scene, by key of the table. */
  get held(): Values {
    return this.values;
  }

  /** Where the scene wants it now, by every key of the table that is about it. */
  get wanted(): Values {
    const { target, azimuth, elevation, distance } = this.scenes();
    return rounded({
      ...targetValues(target),
      'camera.azimuth': wrapped(MathUtils.radToDeg(azimuth)),
      'camera.elevation': MathUtils.radToDeg(elevation),
      'camera.distance': distance,
    });
  }

  /** Takes what the `camera.*` of these values say and gives the scene back what they leave out. */
  hold(values: Values): void {
    const given = rows.flatMap(({ key }) => (values[key] === undefined ? [] : [[key, values[key]] as const]));
    this.values = Object.fromEntries(given);
    this.settle();
  }

  /** Turns about the target, radians. */
  orbit(azimuth: number, elevation: number): void {
    const { theta, phi } = this.place;
    this.take({
      'camera.azimuth': wrapped(MathUtils.radToDeg(theta + azimuth)),
      'camera.elevation': 90 - MathUtils.radToDeg(phi - elevation),
    });
  }

  /** Comes nearer by a factor above 1. */
  zoom(factor: number): void {
    this.take({ 'camera.distance': this.place.radius / factor });
  }

  /** Shifts the target along the picture; the height of the view in pixels says how far a pixel goes. */
  pan(x: number, y: number, heightInPixels: number): void {
    const metres =
      (2 * this.place.radius * Math.tan(MathUtils.degToRad(this.camera.fov) / 2)) / Math.max(heightInPixels, 1);
    const right = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 0);
    const up = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 1);
    this.take(targetValues(this.centre.addScaledVector(right, -x * metres).addScaledVector(up, y * metres)));
  }

  /** Goes where the scene wants its camera at a simulated time, but for what somebody has taken. */
  follow(seconds: number): void {
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

  private take(values: Record<string, number>): void {
    const taken = rounded(values);
    requireFinite(taken);
    this.values = { ...this.values, ...taken };
    this.settle();
  }

  /** Where the scene wants it now; radians. */
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
    this.target.set(this.taken('target.x') ?? x, this.taken('target.y') ?? y, this.taken('target.z') ?? z);
    this.place.set(
      this.taken('distance') ?? distance,
      Math.PI / 2 - (this.takenAngle('elevation') ?? elevation),
      this.takenAngle('azimuth') ?? azimuth,
    );
    this.apply();
  }

  private taken(name: string): number | undefined {
    return this.values[`camera.${name}`] as number | undefined;
  }

  private takenAngle(name: string): number | undefined {
    const degrees = this.taken(name);
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

/** The same direction, within half a turn of 0. */
function wrapped(degrees: number): number {
  return MathUtils.euclideanModulo(degrees + 180, 360) - 180;
}

/** Within the ranges of the table, and short. */
function rounded(values: Record<string, number>): Values {
  const taken = rows.filter(({ key }) => values[key] !== undefined);
  return Object.fromEntries(
    taken.map(({ key, unit, min, max }) => {
      const decimals = unit === 'm' ? DECIMALS.metres : DECIMALS.angle;
      // The addition turns -0 into 0, which is how it would come back from a link.
      return [key, Number(MathUtils.clamp(values[key], min, max).toFixed(decimals)) + 0];
    }),
  );
}
