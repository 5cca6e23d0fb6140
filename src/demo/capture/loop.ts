import type { FrameInput } from '../../internal.ts';
import { shootClip, type Task } from './clip.ts';
import { frameCount, type CaptureSettings } from './settings.ts';
import { joined, stillOf, type Still } from './still.ts';
import type { Studio } from './studio.ts';

/** Length of the transition from the end to the beginning, and its maximum fraction of the clip. */
const JOIN_SECONDS = 0.75;
const JOIN_SHARE = 0.5;

/**
 * Renders a clip that loops. It stores the smoke from before the first frame, and at the end the smoke dissolves into
 * it.
 * @param shoot as in shootClip; also gets what the frame was drawn from
 */
export async function shootLoop(
  { stage, ...studio }: Studio,
  settings: CaptureSettings,
  task: Task,
  shoot: (frame: number, drawn: FrameInput) => Promise<void> | void,
): Promise<void> {
  const count = frameCount(settings);
  const lead = Math.floor(Math.min(JOIN_SECONDS * settings.rate, JOIN_SHARE * count));
  const stills: Still[] = [];
  let [frame, drawn]: [number, FrameInput | undefined] = [0, undefined];
  stage.running.picture.smoke.overrideFrame((input) => {
    const still = stills[frame - count];
    drawn = still ? joined(input, still, (frame - count + 1) / (lead + 1)) : input;
    return drawn;
  });
  const whole = { ...settings, seconds: (count + lead) / settings.rate };
  await shootClip({ stage, ...studio }, whole, task, async (shot) => {
    if (shot < lead) stills.push(stillOf(drawn!));
    else await shoot(shot - lead, drawn!);
    frame = shot + 1;
  });
}
