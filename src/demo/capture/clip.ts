import { nextTask } from '../../internal.ts';
import { frameCount, type CaptureSettings } from './settings.ts';
import type { Studio } from './studio.ts';

/** A long-running operation that can be cancelled. */
export interface Task {
  readonly signal: AbortSignal;
  /** Called with the progress, 0 to 1. */
  readonly onProgress: (share: number) => void;
}

/**
 * Renders a clip frame by frame in simulated time, so that no frame is dropped, however long rendering takes.
 * @param shoot captures a frame; it must read the canvas before its first await
 * @throws the signal's reason when the task is aborted
 */
export async function shootClip(
  { stage, draw }: Studio,
  settings: CaptureSettings,
  { signal, onProgress }: Task,
  shoot: (frame: number) => Promise<void> | void,
): Promise<void> {
  const count = frameCount(settings);
  const start = stage.stats.time;
  for (let frame = 0; frame < count; ++frame) {
    if (frame === 0) draw();
    else stage.running.showAt(start + frame / settings.rate);
    await shoot(frame);
    onProgress((frame + 1) / count);
    await nextTask();
    signal.throwIfAborted();
  }
}
