import type { Color } from '../device/ramps.ts';
import type { TriangleMesh } from '../passes/extrusion.ts';
import type { SurfaceDescription } from '../passes/surfaces.ts';
import type { RigidDescription } from '../sim/rigid.ts';

/** Where a scene wants its camera: angles in radians, lengths in metres. */
export interface CameraPose {
  target: readonly [number, number, number];
  /** About the vertical; 0 looks from +z, positive goes to the right (+x). */
  azimuth: number;
  /** Above the horizon. */
  elevation: number;
  distance: number;
  /** Vertical field of view. */
  fieldOfView: number;
}

/** A rigid that people can move, and the box that its centre stays in, metres. */
export interface Handle {
  rigid: number;
  radius: number;
  start: readonly [number, number, number];
  min: readonly [number, number, number];
  max: readonly [number, number, number];
}

/** What a stage needs to set up: plain data, made anew for each stage. */
export interface Scene {
  name: string;
  /** Simulator values by flat key: the emitters and forces that the parameters then turn up and down. */
  rig: Readonly<Record<string, number>>;
  /** In the order of their numbers. A scene without rigids never loads the physics. */
  rigids: readonly RigidDescription[];
  /** What people call them, by their number: emitters and forces can ride on any of them. */
  rigidNames: readonly string[];
  surfaces: readonly SurfaceDescription[];
  /** Meshes that emitters smoke from, in the order of their numbers; none of them is drawn. */
  emissionSurfaces?: readonly Pick<TriangleMesh, 'positions' | 'indices'>[];
  handle?: Handle;
  camera: CameraPose;
  backdrop?: { top: Color; bottom: Color };
}
