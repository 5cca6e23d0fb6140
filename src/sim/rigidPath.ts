/** Descriptions of paths and spins of kinematic rigids, and their packing for WASM. */
import { ParameterError } from '../preset/errors.ts';
import { poseNumbers, type QuaternionLike, type Triple } from './pose.ts';

/** A pose at a simulation time (s). */
export interface Keyframe {
  time: number;
  /** Metres, world space. */
  position: Triple;
  /** Unit quaternion x, y, z, w; identity if omitted. */
  rotation?: QuaternionLike;
}

/** Pose of a kinematic rigid over simulation time. A rigid off its path moves towards it at up to 120 m/s. */
export type RigidPath =
  /**
   * 1 to 1024 keyframes with increasing times, at constant speed in between. After the last the rigid rests or loops.
   */
  | { type: 'keyframes'; frames: readonly Keyframe[]; loop?: boolean }
  /**
   * A centripetal Catmull-Rom spline through 2 to 256 points, traversed at constant speed from time 0, for `duration`
   * seconds or at `speed` m/s. It is closed if it loops. With `along`, the rigid's z axis points along the path and its
   * y axis up.
   */
  | ({ type: 'spline'; points: readonly Triple[]; loop?: boolean; along?: boolean } & (
      { duration: number; speed?: undefined } | { speed: number; duration?: undefined }
    ));

/** A constant spin about an axis in the rigid's local space. */
export interface RigidSpin {
  axis: Triple;
  /** rad/s. No point of the rigid may exceed 120 m/s. */
  rate: number;
}

/**
 * Packs a path for `sim-wasm/sim/src/rigids/path.rs`; empty if there is no path.
 * @throws ParameterError for an unknown type
 */
export function pathNumbers(path: RigidPath | undefined): Float32Array {
  if (path === undefined) return new Float32Array();
  const loop = path.loop ? 1 : 0;
  switch (path.type) {
    case 'keyframes': {
      const frames = path.frames.flatMap(({ time, position, rotation }) => [time, ...poseNumbers(position, rotation)]);
      return Float32Array.of(0, loop, ...frames);
    }
    case 'spline': {
      const bySpeed = path.speed !== undefined;
      const pace = bySpeed ? path.speed : path.duration;
      const points = path.points.flatMap((point) => [point[0], point[1], point[2]]);
      return Float32Array.of(1, loop, path.along ? 1 : 0, bySpeed ? 1 : 0, pace, ...points);
    }
    default:
      throw new ParameterError('rigid.path.type', (path as RigidPath).type, 'one of keyframes, spline');
  }
}

/** Axis and rate in rad/s; the rate is 0 if `spin` is omitted. */
export function spinNumbers(spin: RigidSpin | undefined): [x: number, y: number, z: number, rate: number] {
  return spin === undefined ? [0, 1, 0, 0] : [spin.axis[0], spin.axis[1], spin.axis[2], spin.rate];
}
