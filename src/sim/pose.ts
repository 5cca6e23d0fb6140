/** Places and rotations as they cross into WASM. */

/** x, y, z. */
export type Triple = ArrayLike<number>;
/** Unit quaternion x, y, z, w. */
export type Quaternion = ArrayLike<number>;

/** Position, then the quaternion x, y, z, w. */
export type PoseNumbers = [x: number, y: number, z: number, i: number, j: number, k: number, w: number];

const NO_ROTATION = [0, 0, 0, 1];

/** Position and rotation as the seven numbers of a pose. */
export function poseNumbers(position: Triple, rotation: Quaternion = NO_ROTATION): PoseNumbers {
  return [position[0], position[1], position[2], rotation[0], rotation[1], rotation[2], rotation[3]];
}
