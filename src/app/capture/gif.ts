import { GIFEncoder } from 'gifenc';
import { type Task, shootClip } from './clip.ts';
import { indexFrame } from './gifPalette.ts';
import { pixelSize, type CaptureSettings, frameCount } from './settings.ts';
import { PixelReader } from './pixels.ts';
import type { Studio } from './studio.ts';
import type { FrameInput } from '../../smoke/frameInput.ts';
import { joined, stillOf, type Still } from './still.ts';

const FOREVER = 0;
/** What was drawn goes before the next frame, or a hole would show it. */
const RESTORE_BACKGROUND = 2;

/** A GIF that goes on for ever: its end leads to its beginning. */
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

/** Milliseconds in whole hundredths of a second, as long together as the frames shall be. */
function delayOf(frame: number, rate: number): number {
  const until = (count: number) => Math.round((100 * count) / rate);
  return 10 * (until(frame + 1) - until(frame));
}

/** How long the end takes to turn into the beginning, and which share of the clip at most. */
const JOIN_SECONDS = 0.75;
const JOIN_SHARE = 0.5;

/**
 * Goes through a clip whose last frame leads to its first: what comes before the first frame is kept, and at the end
 * the smoke turns into it.
 * @param shoot as of shootClip
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
