import type { Color } from '../device/ramps.ts';
import type { TriangleMesh } from '../passes/extrusion.ts';
import type { SurfaceDescription } from '../passes/surfaces.ts';
import type { Quaternion } from '../sim/exact/rotation.ts';
import type { RigidDescription, RigidPart } from '../sim/rigid.ts';

export type Vector = readonly [x: number, y: number, z: number];

/** Where a thing is and how it is turned; metres. */
export interface Placement {
  readonly position: Vector;
  readonly rotation: Quaternion;
}

/** Where a scene wants its camera: angles in radians, lengths in metres. */
export interface CameraPose {
  target: Vector;
  /** About the vertical; 0 looks from +z, positive goes to the right (+x). */
  azimuth: number;
  /** Above the horizon. */
  elevation: number;
  distance: number;
  /** Vertical field of view. */
  fieldOfView: number;
  /** However narrow the window, so much is seen from side to side. */
  minWidth?: number;
  /** In the place of the distance: a metre is so many CSS pixels, so that smoke is as large in small pictures as in large. */
  pixelsPerMetre?: number;
}

/** What a moving camera adds to its pose: radians, and metres for the target. */
export interface CameraShift {
  target?: Vector;
  azimuth?: number;
  elevation?: number;
  /** A factor. */
  distance?: number;
}

/** A camera that moves by itself until somebody takes it, by simulated seconds alone: a moment has one picture. */
export type CameraMove = (seconds: number) => CameraShift;

/** What a moving light adds to its angles, degrees. */
export interface LightShift {
  azimuth: number;
  elevation: number;
}

/** A light that moves by itself, by simulated seconds alone; what people choose is where it would stand without. */
export type LightMove = (seconds: number) => LightShift;

/** A rigid that people can move, and the box that its centre stays in, metres. */
export interface Handle {
  rigid: number;
  /** Of the ball around its centre in which a pointer grabs it. */
  radius: number;
  start: Vector;
  min: Vector;
  max: Vector;
  /**
   * Without it a spring draws the rigid. With it people only say where it should go, and the scene's guide takes it
   * there: these channels hold the place in the box along x, y and z, -1 to 1 from `min` to `max`.
   */
  steers?: readonly [x: number, y: number, z: number];
}

/** What a guide knows of the step that comes. All of it is in saved states, so that seeking and takes stay exact. */
export interface SceneState {
  /** Simulated time at the end of the coming step, seconds. */
  readonly seconds: number;
  /** Length of a step, seconds. */
  readonly dt: number;
  /** What a channel was steered to, -1 to 1; 0 until somebody steers. */
  readonly control: (channel: number) => number;
  /** Where a rigid is before the step. */
  readonly pose: (rigid: number) => Placement;
}

/** The same, and what rules need besides. */
export interface MovingSceneState extends SceneState {
  /** Where a rigid was one step earlier. */
  readonly before: (rigid: number) => Placement;
}

/**
 * Leads rigids, step by step: returns where kinematic ones shall be at the end of the coming step, and where dynamic
 * ones shall begin it, at rest. It keeps nothing itself; what must last from step to step is in the poses that it reads
 * back.
 */
export type Guide = (moment: SceneState) => readonly (Placement & { readonly rigid: number })[];

/** Simulator values that follow from what the rigids do. No take and no link holds them: they are set again. */
export interface Rule {
  /** Of all values that it ever sets. */
  readonly keys: readonly string[];
  /** What to set before the coming step, by flat key. As a guide it keeps nothing itself. */
  readonly values: (moment: MovingSceneState) => Readonly<Record<string, number>>;
}

/**
 * Something that moves and that no smoke bumps into, such as a wheel: drawn where its pose says. Emitters and forces can
 * ride on it.
 */
export interface MovingPart {
  /** What people call it. */
  readonly name: string;
  /** Number of the rigid that carries it, in whose space the pose is meant; the world's where absent. */
  readonly rigid?: number;
  /** By simulated seconds alone; asked at moments between two steps, too. Less than half a turn in a step. */
  readonly pose: (seconds: number) => Placement;
}

/** What a stage needs to set up: plain data, which stages share and none changes. */
export interface Scene {
  name: string;
  /** Simulator values by flat key: the emitters and forces that the parameters then turn up and down. */
  rig: Readonly<Record<string, number>>;
  /** In the order of their numbers. A scene without rigids never loads the physics. */
  rigids: readonly RigidDescription[];
  /** What people call them, by their number: emitters and forces can ride on any of them. */
  rigidNames: readonly string[];
  guide?: Guide;
  rule?: Rule;
  surfaces: readonly SurfaceDescription[];
  /** In the order of the numbers by which surfaces name them, 64 at most. */
  parts?: readonly MovingPart[];
  /** Meshes that emitters smoke from, in the order of their numbers; none of them is drawn. */
  emissionSurfaces?: readonly Pick<TriangleMesh, 'positions' | 'indices'>[];
  handle?: Handle;
  /** Rigids that people can drop into it; where absent, those that `drops.ts` brings along. */
  drops?: readonly number[];
  /** What dropped things fall on besides the rigids of the scene. */
  ground?: readonly RigidPart[];
  camera: CameraPose;
  /** What differs in a picture that is higher than wide. */
  portrait?: Partial<CameraPose>;
  cameraMove?: CameraMove;
  lightMove?: LightMove;
  /** What the light's angles and distance are measured from; what the camera looks at where absent. */
  lightCentre?: Vector;
  backdrop?: { top: Color; bottom: Color };
}
