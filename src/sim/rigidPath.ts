/**
 * Paths and spin of kinematic rigids as a caller describes them, and as they cross into WASM.
 */
import { ParameterError } from '../preset/errors.ts';
import { poseNumbers, type QuaternionLike, type Triple } from './pose.ts';

/** A pose at a time of the simulator (s). */
export interface Keyframe {
  time: number;
  /** Metres, world space. */
  position: Triple;
  /** Unit quaternion x, y, z, w; no rotation when left out. */
  rotation?: QuaternionLike;
}

/**
 * Where a kinematic rigid is at each time of the simulator. A rigid that is elsewhere goes to its path at up to 120 m/s.
 */
export type RigidPath =
  /** 1 to 1024 frames in the order of their times, joined at an even pace; after the last it stays, or begins anew. */
  | { type: 'keyframes'; frames: readonly Keyframe[]; loop?: boolean }
  /**
   * A centripetal Catmull-Rom spline through 2 to 256 points at an even pace, from time 0 on, for `duration` seconds or
   * at `speed` m/s; closed when it loops. `along`: the rigid's z axis looks ahead, its y axis up.
   */
  | ({ type: 'spline'; points: readonly Triple[]; loop?: boolean; along?: boolean } & (
      { duration: number; speed?: undefined } | { speed: number; duration?: undefined }
    ));

/** A steady spin about an axis in the rigid's own space. */
export interface RigidSpin {
  axis: Triple;
  /** rad/s; no point of the rigid may be faster than 120 m/s. */
  rate: number;
}

/** The numbers of `sim/src/rigids/path.rs`; none for no path. */
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

/** Axis and rate; none when left out. */
export function spinNumbers(spin: RigidSpin | undefined): [x: number, y: number, z: number, rate: number] {
  return spin === undefined ? [0, 1, 0, 0] : [spin.axis[0], spin.axis[1], spin.axis[2], spin.rate];
}
