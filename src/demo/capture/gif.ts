import { GIFEncoder } from 'gifenc';
import type { Task } from './clip.ts';
import { indexFrame } from './gifPalette.ts';
import { shootLoop } from './loop.ts';
import { pixelSize, type CaptureSettings } from './settings.ts';
import { PixelReader } from './pixels.ts';
import type { Studio } from './studio.ts';

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
