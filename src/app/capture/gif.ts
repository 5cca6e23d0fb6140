import { GIFEncoder } from 'gifenc';
import { type Task, shootClip } from './clip.ts';
import { indexFrame } from './gifPalette.ts';
import { pixelSize, type CaptureSettings, frameCount } from './settings.ts';
import { PixelReader } from './pixels.ts';
import type { Studio } from './studio.ts';
import type { FrameInput } from '../../internal.ts';
import { joined, stillOf, type Still } from './still.ts';

const FOREVER = 0;
/** GIF disposal method: clears the previous frame, which would otherwise show through transparent pixels. */
const RESTORE_BACKGROUND = 2;

/** Encodes a GIF that loops without a visible seam. */
export async function makeGif(studio: Studio, settings: CaptureSettings, task: Task): Promise<Blob> {
  const [width, height] = pixelSize(settings);
  const reader = new PixelReader(width, height);
  const encoder = GIFEncoder();
  await shootLoop(studio, settings, task, (frame) => {
    const { palette, indices, transparent } = indexFrame(reader.read(studio.canvas));
    encoder.writeFrame(indices, width, height, {
      palette,
      delay: delayOf(frame, settings.rate),
      repeat: FOREVER,
      transparent: transparent !== undefined,
      transparentIndex: transparent ?? 0,
      dispose: transparent === undefined ? -1 : RESTORE_BACKGROUND,
    });
  });
  encoder.finish();
  return new Blob([encoder.bytes()], { type: 'image/gif' });
}

/** Delay of a frame in milliseconds, a multiple of 10. Rounding errors do not accumulate over frames. */
function delayOf(frame: number, rate: number): number {
  const until = (count: number) => Math.round((100 * count) / rate);
  return 10 * (until(frame + 1) - until(frame));
}

/** Length of the transition from the end to the beginning, and its maximum fraction of the clip. */
const JOIN_SECONDS = 0.75;
const JOIN_SHARE = 0.5;

/**
 * Renders a clip that loops. It stores the smoke from before the first frame, and at the end the smoke dissolves into
 * it.
 * @param shoot as in shootClip
 */
async function shootLoop(
  { stage, ...studio }: Studio,
  settings: CaptureSettings,
  task: Task,
  shoot: (frame: number) => Promise<void> | void,
): Promise<void> {
  const count = frameCount(settings);
  const lead = Math.floor(Math.min(JOIN_SECONDS * settings.rate, JOIN_SHARE * count));
  const stills: Still[] = [];
  let [frame, drawn]: [number, FrameInput | undefined] = [0, undefined];
  stage.retouch((input) => {
    drawn = input;
    const still = stills[frame - count];
    return still ? joined(input, still, (frame - count + 1) / (lead + 1)) : input;
  });
  const whole = { ...settings, seconds: (count + lead) / settings.rate };
  await shootClip({ stage, ...studio }, whole, task, async (shot) => {
    if (shot < lead) stills.push(stillOf(drawn!));
    else await shoot(shot - lead);
    frame = shot + 1;
  });
}
