import { MathUtils, Matrix4, Quaternion, Vector3, type Camera } from 'three';
import { ALL_THAT_LIVES, type FrameInput, type Light } from '../../internal.ts';
import { JoinedSmoke, keep, type RetainedSmoke } from './joinedSmoke.ts';

/** The inputs of a frame, stored while the stage continues. */
export interface Still {
  readonly smoke: RetainedSmoke;
  readonly camera: Camera;
  readonly light: Light;
  readonly rigids: readonly Matrix4[];
  readonly parts: readonly Matrix4[];
}

export function stillOf({ simulator, camera, light, rigids, parts = [], blend }: FrameInput): Still {
  const copies = (matrices: readonly Matrix4[]) => matrices.map((matrix) => matrix.clone());
  const smoke = keep(simulator, { ...ALL_THAT_LIVES, blend });
  return { smoke, camera: camera.clone(), light, rigids: copies(rigids), parts: copies(parts) };
}

/**
 * A frame in transition between two times: the smoke dissolves, and rigids, camera and light are interpolated.
 * @param share progress of the transition, 0 to 1
 */
export function joined(from: FrameInput, to: Still, share: number): FrameInput {
  const eased = MathUtils.smoothstep(share, 0, 1);
  const between = (a: readonly Matrix4[], b: readonly Matrix4[]) => a.map((matrix, at) => mixed(matrix, b[at], eased));
  return {
    ...from,
    simulator: new JoinedSmoke(from.simulator, to.smoke, share),
    camera: seenBetween(from.camera, to.camera, eased),
    light: litBetween(from.light, to.light, eased),
    rigids: between(from.rigids, to.rigids),
    parts: between(from.parts ?? [], to.parts),
  };
}

function seenBetween(from: Camera, to: Camera, eased: number): Camera {
  const camera = from.clone();
  camera.position.lerp(to.position, eased);
  camera.quaternion.slerp(to.quaternion, eased);
  camera.updateMatrixWorld();
  return camera;
}

function litBetween(from: Light, to: Light, eased: number): Light {
  if (from.kind !== 'sun' || to.kind !== 'sun') return from;
  return { kind: 'sun', towards: from.towards.clone().lerp(to.towards, eased).normalize() };
}

/** Interpolates between two poses of a rigid. */
function mixed(from: Matrix4, to: Matrix4, eased: number): Matrix4 {
  const [place, rotation, size] = [new Vector3(), new Quaternion(), new Vector3()];
  const [otherPlace, otherRotation] = [new Vector3(), new Quaternion()];
  from.decompose(place, rotation, size);
  to.decompose(otherPlace, otherRotation, new Vector3());
  return new Matrix4().compose(place.lerp(otherPlace, eased), rotation.slerp(otherRotation, eased), size);
}
