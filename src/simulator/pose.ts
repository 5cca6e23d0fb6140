/** Poses packed for WASM. */
import { POSE_FLOATS, RIGID_FLOATS } from './layout.ts';

/** x, y, z. */
export type Triple = ArrayLike<number>;
/** Unit quaternion x, y, z, w. */
export type QuaternionLike = ArrayLike<number>;

/** Position, then the quaternion x, y, z, w. */
export type PoseNumbers = [x: number, y: number, z: number, i: number, j: number, k: number, w: number];

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
