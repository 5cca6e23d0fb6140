import type { Stage } from '../../index.ts';
import type { Studio, Task } from '../../internal.ts';
import type { CaptureSettings, Format } from './settings.ts';
import { openCopy } from './studio.ts';

type Maker = (studio: Studio, settings: CaptureSettings, task: Task) => Promise<Blob>;

/** Encoders by format. Each module and its library are fetched on first use. */
const makers: Readonly<Record<Format, () => Promise<Maker>>> = {
  png: async () => (await import('./png.ts')).makePng,
  svg: async () => (await import('./svg.ts')).makeSvg,
  apng: async () => (await import('./clips/loops.ts')).makeLoop,
  webp: async () => (await import('./clips/loops.ts')).makeLoop,
  gif: async () => (await import('./clips/loops.ts')).makeLoop,
  webm: async () => (await import('./video.ts')).makeVideo,
  mp4: async () => (await import('./video.ts')).makeVideo,
  zip: async () => (await import('./pngSequence.ts')).makePngSequence,
  flipbook: async () => (await import('./flipbook.ts')).makeFlipbook,
};

/**
 * Captures what a stage shows, from the current time on, as a file. The stage is not modified.
 * @throws the reason of the task's signal when it is aborted; VideoError when the browser has no encoder for the format
 */
export async function capture(stage: Stage, settings: CaptureSettings, task: Task): Promise<Blob> {
  const make = await makers[settings.format]();
  const studio = await openCopy(stage, settings);
  try {
    task.signal.throwIfAborted();
    return await make(studio, settings, task);
  } finally {
    studio.stage.dispose();
  }
}
