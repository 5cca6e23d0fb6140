import { type FrameInput, ALL_THAT_LIVES, type Light } from '../../internal.ts';
import { shootClip, type Task, type Studio } from './studio.ts';
import { frameCount, type CaptureSettings } from './settings.ts';
import { MathUtils, Matrix4, Quaternion, Vector3, type Camera } from 'three';
import { JoinedSmoke, keep, type RetainedSmoke } from './joinedSmoke.ts';

/** Length of the transition from the end to the beginning, and its maximum fraction of the clip. */
const JOIN_SECONDS = 0.75;
const JOIN_SHARE = 0.5;

/**
 * Renders a clip that loops. It stores the smoke from before the first frame, and at the end the smoke dissolves into
 * it.
 * @param shoot as in shootClip; also gets what the frame was drawn from
 * @param change of each input of a frame, after the transition
 */
export async function shootLoop(
  { stage, ...studio }: Studio,
  settings: CaptureSettings,
  task: Task,
  shoot: (frame: number, drawn: FrameInput) => Promise<void> | void,
  change: (input: FrameInput) => FrameInput = (input) => input,
): Promise<void> {
  const count = frameCount(settings);
  const lead = Math.floor(Math.min(JOIN_SECONDS * settings.rate, JOIN_SHARE * count));
  const stills: Still[] = [];
  let [frame, drawn]: [number, FrameInput | undefined] = [0, undefined];
  stage.running.picture.smoke.overrideFrame((input) => {
    const still = stills[frame - count];
    drawn = still ? joined(input, still, (frame - count + 1) / (lead + 1)) : input;
    return change(drawn);
  });
  const whole = { ...settings, seconds: (count + lead) / settings.rate };
  await shootClip({ stage, ...studio }, whole, task, async (shot) => {
    if (shot < lead) stills.push(stillOf(drawn!));
    else await shoot(shot - lead, drawn!);
    frame = shot + 1;
  });
}

/** The inputs of a frame, stored while the stage continues. */
interface Still {
  readonly smoke: RetainedSmoke;
  readonly camera: Camera;
  readonly light: Light;
  readonly rigids: readonly Matrix4[];
  readonly parts: readonly Matrix4[];
}

export function stillOf({ simulator, camera, light, rigids, parts = [], blend, style }: FrameInput): Still {
  const copies = (matrices: readonly Matrix4[]) => matrices.map((matrix) => matrix.clone());
  const smoke = keep(simulator, { ...ALL_THAT_LIVES, blend }, style);
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
