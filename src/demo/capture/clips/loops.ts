import { strings } from '../../strings.ts';
import { shootLoop } from '../loop.ts';
import { PixelReader } from '../pixels.ts';
import { pixelSize, type CaptureSettings } from '../settings.ts';
import { VideoError, type Studio, type Task } from '../studio.ts';
import type { LoopFormat } from './clipFile.ts';
import { ClipEncoder } from './encoder.ts';
import { encodesWebp } from './webp.ts';

/**
 * Encodes a clip that loops without a visible seam.
 * @throws VideoError when the browser cannot encode the format
 */
export async function makeLoop(studio: Studio, settings: CaptureSettings, task: Task): Promise<Blob> {
  const format = settings.format as LoopFormat;
  if (format === 'webp' && !(await encodesWebp())) throw new VideoError(strings.capture.noWebp);
  return (await makeLoops([format], studio, settings, task))[0];
}

/**
 * Encodes the same loop in several formats.
 * @param formats that the browser can encode
 * @returns files in the order of the formats
 */
export async function makeLoops(
  formats: readonly LoopFormat[],
  studio: Studio,
  settings: CaptureSettings,
  task: Task,
): Promise<readonly Blob[]> {
  const [width, height] = pixelSize(settings);
  const reader = new PixelReader(width, height);
  const encoder = new ClipEncoder(formats, { width, height, rate: settings.rate });
  try {
    const add = () => encoder.add(reader.read(studio.canvas).data);
    await shootLoop(studio, settings, task, add);
    return await encoder.finish();
  } finally {
    encoder.close();
  }
}
