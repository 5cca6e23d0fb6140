/** The large part of clips, loaded with the first one. */
import { UnsupportedError } from '../../base/errors.ts';
import type { StageOptions } from '../../stage/contract.ts';
import { createStage, type Stage } from '../../stage/stage.ts';
import type { ClipOrder, ClippedSmoke } from './options.ts';
import { encodesWebp } from './encoder.ts';
import { record } from './record.ts';
import { openStudio } from './studio.ts';

/** See `clip`. */
export async function makeClip(smoke: ClippedSmoke | Stage, order: ClipOrder): Promise<Blob> {
  const { format, pixelRatio, signal, onProgress } = order;
  if (format === 'webp' && !(await encodesWebp()))
    throw new UnsupportedError('This browser cannot encode WebP. Use the format apng, which every browser shows.');
  const [width, height] = [order.width, order.height].map((side) => Math.max(1, Math.round(side * pixelRatio)));
  const size = { width, height, scale: pixelRatio, hasBackground: order.background };
  const studio = await openStudio((canvas, options) => copyOf(smoke, canvas, options, order), size);
  try {
    signal.throwIfAborted();
    const recording = { width, height, seconds: order.duration, rate: order.fps, isLoop: order.loop };
    return (await record([format], studio, recording, { signal, onProgress }))[0];
  } finally {
    studio.stage.dispose();
  }
}

/** Another stage with the same smoke on this thread, wherever the smoke is. */
async function copyOf(
  smoke: ClippedSmoke | Stage,
  canvas: HTMLCanvasElement,
  options: StageOptions,
  { model, modelOptions, signal }: ClipOrder,
): Promise<Stage> {
  if ('copy' in smoke) return smoke.copy(canvas, options);
  // Asked in one task, so that no change comes between the answers.
  const [values, state] = await unlessAborted(Promise.all([smoke.get(), smoke.save()]), signal);
  const stage = await createStage(canvas, { ...options, values });
  try {
    if (model) await stage.setModel(model, modelOptions);
    stage.restore(state);
    return stage;
  } catch (error) {
    stage.dispose();
    throw error;
  }
}

/** The smoke of an element may take long to load. */
function unlessAborted<Value>(coming: Promise<Value>, signal: AbortSignal): Promise<Value> {
  return new Promise((resolve, reject) => {
    signal.addEventListener('abort', () => reject(signal.reason as Error), { once: true });
    coming.then(resolve, reject);
  });
}
