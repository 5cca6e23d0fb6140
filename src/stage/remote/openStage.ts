import { ContextError, ParameterError, requireOptions, UnsupportedError } from '../../base/errors.ts';
import { fetched } from '../../base/timeout.ts';
import { STAGE_OPTIONS } from '../contract.ts';
import type { RemoteStage, RemoteStageOptions } from './contract.ts';
import type { WorkerSlot } from './openInWorker.ts';

/**
 * Opens a stage in a worker if the browser supports it and the page allows it, otherwise on the main thread, with the
 * same pictures. It draws only while its canvas is in the viewport and its page is visible. It does not start playback.
 * @param makeCanvas creates a canvas and adds it to the page. Called again when the stage falls back to the main thread
 * after the canvas was transferred; it must then remove the old canvas
 * @throws ParameterError for an invalid value, LoadError when something cannot be fetched, UnsupportedError when the
 * browser lacks WebGL2 or WASM SIMD
 */
export async function openStage(
  makeCanvas: () => HTMLCanvasElement,
  options: RemoteStageOptions = {},
): Promise<RemoteStage> {
  if (typeof makeCanvas !== 'function')
    throw new ParameterError('makeCanvas', makeCanvas, 'a function that returns a canvas');
  requireOptions('openStage', options, [...STAGE_OPTIONS, 'thread', 'signal', 'graceMs']);
  const { thread = 'auto', signal } = options;
  const place = thread === 'main' ? undefined : await slotInWorker(thread);
  if (place) {
    if (signal?.aborted) place.leave();
    signal?.throwIfAborted();
    const canvas = makeCanvas();
    try {
      return pausedOffscreen(canvas, await place.open(canvas, options));
    } catch (error) {
      if (thread === 'worker' || !(error instanceof UnsupportedError || error instanceof ContextError)) throw error;
    }
  }
  // A separate chunk, with three.js and the renderer: pages that use a worker never fetch it.
  const { openHere } = await fetched('The smoke', import('./openHere.ts'));
  signal?.throwIfAborted();
  const canvas = makeCanvas();
  return pausedOffscreen(canvas, await openHere(canvas, options));
}

/** @throws when a worker is required and unavailable */
async function slotInWorker(thread: 'auto' | 'worker'): Promise<WorkerSlot | undefined> {
  try {
    const { canMoveCanvas, enterWorker } = await fetched('The worker', import('./openInWorker.ts'));
    if (!canMoveCanvas()) throw new UnsupportedError('This browser cannot transfer a canvas to a worker.');
    return await enterWorker();
  } catch (error) {
    if (thread === 'worker') throw error;
    return undefined;
  }
}

/** Wraps a stage so that it does not draw while its canvas is not visible. */
function pausedOffscreen(canvas: HTMLCanvasElement, stage: RemoteStage): RemoteStage {
  const stopFollowing = watchVisibility(canvas, stage);
  return {
    ...stage,
    dispose() {
      stopFollowing();
      return stage.dispose();
    },
  };
}

/** Drawing starts this far before the canvas enters the viewport. */
const MARGIN = '64px';

/**
 * Tracks whether the canvas is in the viewport and its page is visible. A paused stage stays paused.
 * @returns a function that stops the tracking
 */
function watchVisibility(canvas: HTMLCanvasElement, stage: Pick<RemoteStage, 'setVisible'>): () => void {
  const page = canvas.ownerDocument;
  let isNear = true;
  let notified = true;
  const notify = () => {
    const isVisible = isNear && !page.hidden;
    if (isVisible === notified) return;
    notified = isVisible;
    // Rejects only if the stage was disposed or failed, and then visibility does not matter.
    stage.setVisible(isVisible).catch(() => undefined);
  };
  const observer = new IntersectionObserver(
    (entries) => {
      isNear = entries.at(-1)!.isIntersecting;
      notify();
    },
    { rootMargin: MARGIN },
  );
  observer.observe(canvas);
  page.addEventListener('visibilitychange', notify);
  notify();
  return () => {
    observer.disconnect();
    page.removeEventListener('visibilitychange', notify);
  };
}
