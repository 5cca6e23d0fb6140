import { UnsupportedError } from '../../base/errors.ts';
import { nextTask } from '../../base/work.ts';
import type { StageOptions } from '../../stage/contract.ts';
import type { Stage } from '../../stage/stage.ts';

/** A stage on a canvas of its own, which is not in the page. */
export interface Studio {
  readonly stage: Stage;
  readonly canvas: HTMLCanvasElement;
  /** Draws the stage at its current time. The pixels can be read within the same task. */
  readonly draw: () => void;
}

/** Size in pixels, device pixels per CSS pixel, and whether the background is drawn. */
export interface StudioSize {
  readonly width: number;
  readonly height: number;
  readonly scale: number;
  readonly hasBackground: boolean;
}

/**
 * Opens a stage for pictures of any size.
 * @param open creates the stage on a canvas
 * @throws UnsupportedError when the size exceeds the limit of the GPU; the errors of `open`
 */
export async function openStudio(
  open: (canvas: HTMLCanvasElement, options: StageOptions) => Promise<Stage>,
  { width, height, scale, hasBackground }: StudioSize,
): Promise<Studio> {
  // WebKitGTK does not support WebGL on an OffscreenCanvas.
  const canvas = document.createElement('canvas');
  const stage = await open(canvas, { width: 1, height: 1, background: hasBackground, historyBytes: 0 });
  try {
    requireSize(canvas, width, height);
  } catch (error) {
    stage.dispose();
    throw error;
  }
  // The canvas stays at its minimum size until a frame is requested.
  const draw = () => stage.resize(width / scale, height / scale, scale);
  return { stage, canvas, draw };
}

/** @throws UnsupportedError when a size in pixels exceeds the limit of the GPU that draws on the canvas */
export function requireSize(canvas: HTMLCanvasElement, width: number, height: number): void {
  const context = canvas.getContext('webgl2')!;
  const max = context.getParameter(context.MAX_RENDERBUFFER_SIZE) as number;
  if (Math.max(width, height) <= max) return;
  throw new UnsupportedError(
    `${width} \u00d7 ${height} pixels are too large for this GPU. The limit is ${max} pixels per side.`,
  );
}

/** A long-running operation that can be cancelled. */
export interface Task {
  readonly signal: AbortSignal;
  /** Called with the progress, 0 to 1. */
  readonly onProgress: (share: number) => void;
}

/** Length of a clip in seconds, and its frames per second. */
export interface ClipLength {
  readonly seconds: number;
  readonly rate: number;
}

/** Number of frames in a clip, at least 1. */
export function frameCount({ seconds, rate }: ClipLength): number {
  return Math.max(1, Math.round(seconds * rate));
}

/**
 * Renders a clip frame by frame in simulated time, so that no frame is dropped, however long rendering takes.
 * @param shoot captures a frame; it must read the canvas before its first await
 * @throws the signal's reason when the task is aborted
 */
export async function shootClip(
  { stage, draw }: Studio,
  length: ClipLength,
  { signal, onProgress }: Task,
  shoot: (frame: number) => Promise<void> | void,
): Promise<void> {
  const count = frameCount(length);
  const start = stage.stats.time;
  for (let frame = 0; frame < count; ++frame) {
    if (frame === 0) draw();
    else stage.running.showAt(start + frame / length.rate);
    await shoot(frame);
    onProgress((frame + 1) / count);
    await nextTask();
    signal.throwIfAborted();
  }
}
