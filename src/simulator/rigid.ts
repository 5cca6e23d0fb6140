/** Descriptions of rigids, and their poses as numbers. */
import { ParameterError } from '../base/errors.ts';
import { POSE_FLOATS, RIGID_FLOATS } from './layout.ts';

/** A single shape, centred at its local origin. Capsules and cylinders extend along y. Lengths are in metres. */
export type SingleShape =
  | { type: 'ball'; radius: number }
  | { type: 'cuboid'; halfExtents: Triple }
  /** `halfHeight` is half the height of the straight part; the caps add `radius` at both ends. */
  | { type: 'capsule'; halfHeight: number; radius: number }
  | { type: 'cylinder'; halfHeight: number; radius: number }
  /** Convex hull of at least four points that are not coplanar; x, y, z per point. */
  | { type: 'convexHull'; vertices: ArrayLike<number> }
  /**
   * Triangles of three indices, counter-clockwise seen from outside. Only a closed mesh keeps smoke out of its inside.
   */
  | { type: 'trimesh'; vertices: ArrayLike<number>; indices: ArrayLike<number> };

/** A shape of a compound, with its pose in the rigid's local space. */
export interface RigidPart {
  shape: SingleShape;
  /** Metres. */
  position: Triple;
  /** Unit quaternion x, y, z, w; identity if omitted. */
  rotation?: QuaternionLike;
}

/** One shape, or a compound of 1 to 64 shapes. */
export type RigidShape = SingleShape | { type: 'compound'; parts: readonly RigidPart[] };

/** Surface of a rigid, and what it does to the smoke that touches it. */
export interface RigidSurface {
  /** 0 (default): no bounce. 1: particles and rigids keep their speed. */
  restitution?: number;
  /** 0: frictionless. 1: contacts stop all tangential motion. Default 0.5. */
  friction?: number;
  /** Effect on smoke that touches the rigid: it bounces (default), dies, or passes through with a tint. */
  action?: 'bounce' | 'kill' | 'tint';
  /** Tint for the action `tint`, 1 (default) to 15. */
  tint?: number;
  /** The moving surface drags air along within this distance; metres, 0 (default) to 10. */
  boundaryLayer?: number;
}

/** A rigid body that smoke collides with. */
export interface RigidDescription extends RigidSurface {
  /** `fixed` never moves, `kinematic` follows prescribed motion, `dynamic` responds to gravity and contacts. */
  kind: 'fixed' | 'kinematic' | 'dynamic';
  shape: RigidShape;
  /** Metres. */
  position: Triple;
  /** Unit quaternion x, y, z, w; identity if omitted. */
  rotation?: QuaternionLike;
  /** kg/m3, default 1000. Applies to dynamic rigids. */
  density?: number;
  /** How strongly smoke pushes a dynamic rigid: 0 (default) is off, 1 is as strong as air, at most 10. */
  feelsSmoke?: number;
}

/**
 * Rejects invalid indices before conversion: a Uint32Array would wrap -1 to a valid number.
 * @throws ParameterError for an index that is not an unsigned 32-bit integer
 */
export function requireIndices(indices: ArrayLike<number>, name: string): void {
  for (let index = 0; index < indices.length; index++) {
    const vertex = indices[index];
    if (!Number.isInteger(vertex) || vertex < 0 || vertex > 0xffffffff) {
      throw new ParameterError(`${name}.indices.${index}`, vertex, 'a vertex index');
    }
  }
}

/** Poses packed for WASM. */

/** x, y, z. */
type Triple = ArrayLike<number>;
/** Unit quaternion x, y, z, w. */
type QuaternionLike = ArrayLike<number>;

/** Position, then the quaternion x, y, z, w. */
type PoseNumbers = [x: number, y: number, z: number, i: number, j: number, k: number, w: number];

const NO_ROTATION = [0, 0, 0, 1];

/** Position and rotation as the seven numbers of a pose. */
export function poseNumbers(position: Triple, rotation: QuaternionLike = NO_ROTATION): PoseNumbers {
  return [position[0], position[1], position[2], rotation[0], rotation[1], rotation[2], rotation[3]];
}

/**
 * Interpolates a pose between two steps: position linearly, rotation by normalised linear interpolation (nlerp) along
 * the shorter arc.
 * @param poses of all rigids, {@link RIGID_FLOATS} each
 * @param index of the rigid
 * @param blend 0 is the previous step, 1 the latest
 * @param result receives the pose, {@link POSE_FLOATS} per rigid
 */
export function blendPose(poses: Float32Array, index: number, blend: number, result: Float32Array): void {
  const before = index * RIGID_FLOATS;
  const now = before + POSE_FLOATS;
  const to = index * POSE_FLOATS;
  let cosine = 0;
  for (let part = 3; part < POSE_FLOATS; part++) cosine += poses[before + part] * poses[now + part];
  const sign = cosine < 0 ? -1 : 1;
  let square = 0;
  for (let part = 0; part < POSE_FLOATS; part++) {
    const end = part < 3 ? poses[now + part] : sign * poses[now + part];
    result[to + part] = poses[before + part] + (end - poses[before + part]) * blend;
    if (part >= 3) square += result[to + part] * result[to + part];
  }
  const scale = 1 / Math.sqrt(square);
  for (let part = 3; part < POSE_FLOATS; part++) result[to + part] *= scale;
}
