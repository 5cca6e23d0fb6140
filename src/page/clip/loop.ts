import { MathUtils, Matrix4, Quaternion, Vector3, type Camera } from 'three';
import type { FrameInput } from '../../renderer/frameInput.ts';
import type { Light } from '../../renderer/light.ts';
import { ALL_PARTICLES } from '../../simulator/view.ts';
import type { Stage } from '../../stage/stage.ts';
import { JoinedSmoke, keep, type RetainedSmoke } from './joinedSmoke.ts';
import { frameCount, shootClip, type ClipLength, type Studio, type Task } from './studio.ts';

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
  { seconds, rate }: ClipLength,
  task: Task,
  shoot: (frame: number, drawn: FrameInput) => Promise<void> | void,
  change: (input: FrameInput) => FrameInput = (input) => input,
): Promise<void> {
  const count = frameCount({ seconds, rate });
  const join = new LoopJoin(stage, count, rate, change);
  const whole = { rate, seconds: (count + join.lead) / rate };
  await shootClip({ stage, ...studio }, whole, task, async (shot) => {
    if (shot < join.lead) join.keep();
    else await shoot(shot - join.lead, join.drawn!);
    join.shot = shot + 1;
  });
}

/** Draws shots of a stage. The last ones dissolve into the first ones, which are not in the loop. */
export class LoopJoin {
  /** Number of the first shots. */
  readonly lead: number;
  /** Number of the shot that is drawn next, from 0. */
  shot = 0;
  /** What the latest picture was drawn from. */
  drawn: FrameInput | undefined;
  private readonly count: number;
  private readonly stills: Still[] = [];

  /**
   * @param count of the frames of the loop: the shots from `lead` on
   * @param rate frames per second
   * @param change of each input of a frame, after the transition
   */
  constructor(stage: Stage, count: number, rate: number, change = (input: FrameInput): FrameInput => input) {
    this.count = count;
    this.lead = leadOf(count, rate);
    stage.running.picture.smoke.overrideFrame((input) => {
      const at = this.shot - this.count;
      const still = this.stills[at];
      this.drawn = still ? joined(input, still, (at + 1) / (this.lead + 1)) : input;
      return change(this.drawn);
    });
  }

  /** Whether a shot dissolves into one of the first ones, which have to be kept before. */
  needsStill(shot: number): boolean {
    return shot >= this.count;
  }

  /** Keeps what the latest picture was drawn from, after each of the first shots. */
  keep(): void {
    this.stills.push(stillOf(this.drawn!));
  }
}

/** Shots before the loop, into which its end dissolves. */
function leadOf(count: number, rate: number): number {
  return Math.floor(Math.min(JOIN_SECONDS * rate, JOIN_SHARE * count));
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
  const smoke = keep(simulator, { ...ALL_PARTICLES, blend }, style);
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
