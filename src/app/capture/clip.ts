import { nextTask } from '../../stage/seek.ts';
import { frameCount, type CaptureSettings } from './settings.ts';
import type { Studio } from './studio.ts';

/** Work that takes its time, and that somebody may want to end. */
export interface Task {
  readonly signal: AbortSignal;
  /** Called with how much is done, 0 to 1. */
  readonly onProgress: (share: number) => void;
}

/**
 * Goes through a clip frame by frame, in steps of the simulation and not in the time of the machine, so that each frame is
 * there however long it takes.
 * @param shoot takes a frame, which it must read from the canvas before it waits for anything
 * @throws the signal's reason when it was aborted
 */
export async function shootClip(
  { stage, draw }: Studio,
  settings: CaptureSettings,
  { signal, onProgress }: Task,
  shoot: (frame: number) => Promise<void> | void,
): Promise<void> {
  const count = frameCount(settings);
  for (let frame = 0; frame < count; ++frame) {
    if (frame === 0) draw();
    else stage.advance(1 / settings.rate);
    await shoot(frame);
    onProgress((frame + 1) / count);
    await nextTask();
    signal.throwIfAborted();
  }
}
