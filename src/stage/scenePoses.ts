/** Poses of a scene's rigids and parts at a time. */
import { Quaternion, Vector3, type Matrix4 } from 'three';
import type { MovingPart, MovingSceneState, Placement, Scene } from '../scenes/scene.ts';
import { STEP_SECONDS } from '../simulator/clock.ts';
import { POSE_FLOATS } from '../simulator/layout.ts';
import type { Simulator } from '../simulator/simulator.ts';

const UNSCALED = new Vector3(1, 1, 1);

/** What guides and rules read for the next step. */
export function sceneStateOf(simulator: Simulator): MovingSceneState {
  const [then, now] = [simulator.rigidPoses(0), simulator.rigidPoses(1)];
  return {
    seconds: (simulator.steps + 1) * STEP_SECONDS,
    dt: STEP_SECONDS,
    control: (channel) => simulator.control(channel),
    pose: (rigid) => placementIn(now, rigid),
    before: (rigid) => placementIn(then, rigid),
  };
}

/** The scene's parts by index, in the local space of the rigids that carry them. */
export function placedParts(scene: Scene, seconds: number): readonly (Placement & Pick<MovingPart, 'rigid'>)[] {
  return (scene.parts ?? []).map(({ rigid, pose }) => ({ rigid, ...pose(seconds) }));
}

/** The pose of a rigid in the result of `rigidPoses`. */
export function placementIn(poses: Float32Array, rigid: number): Placement {
  const [x, y, z, i, j, k, w] = poses.subarray(POSE_FLOATS * rigid);
  return { position: [x, y, z], rotation: [i, j, k, w] };
}

/** Sets a matrix to a placement. */
export function put(matrix: Matrix4, { position, rotation }: Placement): Matrix4 {
  return matrix.compose(new Vector3(...position), new Quaternion(...rotation), UNSCALED);
}
