import type { Color } from '../renderer/gpu/ramps.ts';
import type { TriangleMesh } from '../renderer/passes/extrusion.ts';
import type { Skin, SurfaceDescription } from '../renderer/passes/surface.ts';
import type { Quaternion } from '../simulator/exact/rotation.ts';
import type { RigidDescription, RigidPart } from '../simulator/rigid.ts';
import type { Dropped } from './dropped.ts';

/** A position or a displacement in metres, or a direction. */
export type Vector = readonly [x: number, y: number, z: number];

/** Position, in metres, and rotation. */
export interface Placement {
  readonly position: Vector;
  readonly rotation: Quaternion;
}

/** A scene's camera: angles in radians, lengths in metres. */
export interface CameraPose {
  target: Vector;
  /** About the vertical axis; 0 looks from +z, positive moves to the right (+x). */
  azimuth: number;
  /** Above the horizon. */
  elevation: number;
  distance: number;
  /** Vertical field of view. */
  fieldOfView: number;
  /** Minimum horizontal field of view, for narrow windows. */
  minWidth?: number;
  /** Replaces the distance: CSS pixels per metre, so that the smoke has the same size in pictures of any size. */
  pixelsPerMetre?: number;
}

/** Offset of a moving camera from its pose: radians, and metres for the target. */
export interface CameraShift {
  target?: Vector;
  azimuth?: number;
  elevation?: number;
  /** A factor. */
  distance?: number;
}

/**
 * A camera movement, until the user moves the camera. A pure function of simulated time, so that seeking reproduces
 * each picture.
 */
export type CameraMove = (seconds: number) => CameraShift;

/** Offset of a moving light's angles, degrees. */
export interface LightShift {
  azimuth: number;
  elevation: number;
}

/** A light movement, a pure function of simulated time. It is added to the light that the user sets. */
export type LightMove = (seconds: number) => LightShift;

/** A rigid that the user can move, and the box that limits its centre, metres. */
export interface Handle {
  rigid: number;
  /** Radius of the sphere around the centre in which a pointer grabs the rigid. */
  radius: number;
  start: Vector;
  min: Vector;
  max: Vector;
  /**
   * Without this, a spring pulls the rigid to its target. With it, the user only sets the target, and the scene's guide
   * moves the rigid. These channels hold the target's position in the box along x, y and z: -1 at `min`, 1 at `max`.
   */
  steers?: readonly [x: number, y: number, z: number];
}

/** A guide's input for the next step. All of it is part of saved states, so that seeking and takes are exact. */
export interface SceneState {
  /** Simulated time at the end of the next step, seconds. */
  readonly seconds: number;
  /** Duration of a step, seconds. */
  readonly dt: number;
  /** Value of a steering channel, -1 to 1; 0 until the user steers. */
  readonly control: (channel: number) => number;
  /** Pose of a rigid before the step. */
  readonly pose: (rigid: number) => Placement;
}

/** A rule's input for the next step. */
export interface MovingSceneState extends SceneState {
  /** Pose of a rigid one step earlier. */
  readonly before: (rigid: number) => Placement;
}

/**
 * Moves rigids step by step. Returns the poses of kinematic rigids at the end of the next step, and the poses in which
 * dynamic rigids start it, at rest. A guide must be stateless: anything that persists between steps is in the poses
 * that it reads.
 */
export type Guide = (moment: SceneState) => readonly (Placement & { readonly rigid: number })[];

/** Simulator values derived from the rigids. Takes and links do not contain them, because the rule sets them again. */
export interface Rule {
  /** All keys that the rule ever sets. */
  readonly keys: readonly string[];
  /** Values to set before the next step, by flat key. Stateless, like a guide. */
  readonly values: (moment: MovingSceneState) => Readonly<Record<string, number>>;
}

/** A moving part without collisions, such as a wheel. Emitters and forces can be attached to it. */
export interface MovingPart {
  /** Display name. */
  readonly name: string;
  /** Index of the rigid that carries the part; the pose is in that rigid's local space. Default: world space. */
  readonly rigid?: number;
  /**
   * A pure function of simulated time, also evaluated between steps. Must turn less than half a revolution per step.
   */
  readonly pose: (seconds: number) => Placement;
}

/** The definition of a scene: immutable plain data, shared between stages. */
export interface Scene {
  name: string;
  /** Simulator values by flat key: the scene's emitters and forces, which the parameters scale. */
  rig: Readonly<Record<string, number>>;
  /** In index order. A scene without rigids does not load the physics engine. */
  rigids: readonly RigidDescription[];
  /** Display names by index. Emitters and forces can be attached to any rigid. */
  rigidNames: readonly string[];
  guide?: Guide;
  rule?: Rule;
  surfaces: readonly SurfaceDescription[];
  /** Transforms of surfaces that bend. */
  skin?: Skin;
  /** In index order, as referenced by surfaces; at most 64. */
  parts?: readonly MovingPart[];
  /** Meshes that emitters use as their source, in index order. They are not drawn. */
  emissionSurfaces?: readonly Pick<TriangleMesh, 'positions' | 'indices'>[];
  handle?: Handle;
  /** Rigids that the user can drop into the scene. Default: the objects of `drops.ts`. */
  drops?: readonly number[];
  /** Creates the state of the objects that the user drops. `withDrops` sets it. */
  createDropped?: () => Dropped;
  /** Colliders for dropped objects, in addition to the scene's rigids. */
  ground?: readonly RigidPart[];
  camera: CameraPose;
  /** Overrides for portrait pictures. */
  portrait?: Partial<CameraPose>;
  cameraMove?: CameraMove;
  lightMove?: LightMove;
  /** Origin of the light's angles and distance. Default: the camera target. */
  lightCentre?: Vector;
  backdrop?: { top: Color; bottom: Color };
}
