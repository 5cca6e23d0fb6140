import type { Stage } from '../../stage/stage.ts';
import type { Task } from './clip.ts';
import type { Format, CaptureSettings } from './settings.ts';
import { openStudio, type Studio } from './studio.ts';

type Maker = (studio: Studio, settings: CaptureSettings, task: Task) => Promise<Blob>;

/** Each comes with its library, and only when it is asked for. */
const makers: Readonly<Record<Format, () => Promise<Maker>>> = {
  png: async () => (await import('./png.ts')).makePng,
  svg: async () => (await import('./svg.ts')).makeSvg,
  gif: async () => (await import('./gif.ts')).makeGif,
  webm: async () => (await import('./video.ts')).makeVideo,
  mp4: async () => (await import('./video.ts')).makeVideo,
  zip: async () => (await import('./pngSequence.ts')).makePngSequence,
};

/**
 * What a stage shows, from this moment on, as a file. The stage is left as it is.
 * @throws the reason of the task's signal when it was aborted, VideoError where the browser has no encoder for the format
 */
export async function capture(stage: Stage, settings: CaptureSettings, task: Task): Promise<Blob> {
  const make = await makers[settings.format]();
  const studio = await openStudio(stage, settings);
  try {
    task.signal.throwIfAborted();
    return await make(studio, settings, task);
  } finally {
    studio.stage.dispose();
  }
}
