import { encodesWebp, record, type ClipFormat, type Studio, type Task } from '../../../internal.ts';
import { strings } from '../../strings.ts';
import { pixelSize, type CaptureSettings } from '../settings.ts';
import { VideoError } from '../studio.ts';

/**
 * Encodes a clip that loops without a visible seam.
 * @throws VideoError when the browser cannot encode the format
 */
export async function makeLoop(studio: Studio, settings: CaptureSettings, task: Task): Promise<Blob> {
  const format = settings.format as ClipFormat;
  if (format === 'webp' && !(await encodesWebp())) throw new VideoError(strings.capture.noWebp);
  return (await makeLoops([format], studio, settings, task))[0];
}

/**
 * Encodes the same loop in several formats.
 * @param formats that the browser can encode
 * @returns files in the order of the formats
 */
export function makeLoops(
  formats: readonly ClipFormat[],
  studio: Studio,
  settings: CaptureSettings,
  task: Task,
): Promise<readonly Blob[]> {
  const [width, height] = pixelSize(settings);
  const { seconds, rate } = settings;
  return record(formats, studio, { width, height, seconds, rate, isLoop: true }, task);
}
