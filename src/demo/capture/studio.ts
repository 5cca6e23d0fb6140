import type { Stage } from '../../index.ts';
import { strings } from '../strings.ts';
import { pixelSize, type CaptureSettings, frameCount } from './settings.ts';
import { nextTask } from '../../internal.ts';

/** A stage on an offscreen canvas. */
export interface Studio {
  readonly stage: Stage;
  readonly canvas: HTMLCanvasElement;
  /** Draws the stage at its current time. The pixels can be read within the same task. */
  readonly draw: () => void;
}

/**
 * Opens a copy of a stage at the requested size. The original stage is not modified.
 * @throws RangeError when the size exceeds the limit of the GPU
 */
export async function openStudio(stage: Stage, settings: CaptureSettings): Promise<Studio> {
  const [width, height] = pixelSize(settings);
  const { scale, hasBackground } = settings;
  // WebKitGTK does not support WebGL on an OffscreenCanvas.
  const canvas = document.createElement('canvas');
  const options = { width: 1, height: 1, background: hasBackground, historyBytes: 0 };
  const copy = await stage.copy(canvas, options);
  const max = maxPixels(canvas);
  if (Math.max(width, height) > max) {
    copy.dispose();
    throw new RangeError(strings.capture.tooLarge(width, height, max));
  }
  // The canvas stays at its minimum size until a frame is requested.
  const draw = () => copy.resize(width / scale, height / scale, scale);
  return { stage: copy, canvas, draw };
}

function maxPixels(canvas: HTMLCanvasElement): number {
  const context = canvas.getContext('webgl2')!;
  return context.getParameter(context.MAX_RENDERBUFFER_SIZE) as number;
}

/** The browser has no encoder for a format. The message suggests an alternative. */
export class VideoError extends Error {
  override name = 'VideoError';
}

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
