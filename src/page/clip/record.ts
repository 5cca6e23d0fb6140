import type { ClipFormat } from './clipFile.ts';
import { openEncoder } from './encoder.ts';
import { PixelReader } from './pixelReader.ts';
import { shootLoop } from './loop.ts';
import { shootClip, type ClipLength, type Studio, type Task } from './studio.ts';

/** What is recorded. */
export interface Recording extends ClipLength {
  /** Size in pixels. */
  readonly width: number;
  readonly height: number;
  /** Whether the last frames dissolve into the first ones. */
  readonly isLoop: boolean;
}

/**
 * Encodes the same clip in several formats.
 * @param formats that the browser can encode
 * @returns files in the order of the formats
 * @throws the signal's reason when the task is aborted, RangeError for a size or a rate that is not accepted
 */
export async function record(
  formats: readonly ClipFormat[],
  studio: Studio,
  { width, height, seconds, rate, isLoop }: Recording,
  task: Task,
): Promise<readonly Blob[]> {
  const reader = new PixelReader(width, height);
  const encoder = await openEncoder(formats, { width, height, rate });
  try {
    const add = () => encoder.add(reader.read(studio.canvas).data);
    await (isLoop ? shootLoop : shootClip)(studio, { seconds, rate }, task, add);
    return await encoder.finish();
  } finally {
    encoder.close();
  }
}
