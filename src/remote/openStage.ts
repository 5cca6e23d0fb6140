import { ContextError, UnsupportedError } from '../preset/errors.ts';
import { fetched } from '../preset/timeout.ts';
import type { RemoteStage, RemoteStageOptions } from './contract.ts';
import type { WorkerSlot } from './openInWorker.ts';

/**
 * Opens a stage in a worker where the browser can and the page allows it, else on this thread, with the same pictures. It
 * draws only while its canvas is in view and its page is not hidden; it does not play yet.
 * @param makeCanvas makes a canvas and puts it on the page; asked again when a canvas that went to the worker is lost to it,
 * and then has to take the old one away
 * @throws ParameterError for a value it does not take, LoadError when something cannot be fetched, UnsupportedError when
 * the browser lacks WebGL2 or WASM SIMD
 */
export async function openStage(
  makeCanvas: () => HTMLCanvasElement,
  options: RemoteStageOptions = {},
): Promise<RemoteStage> {
  const { thread = 'auto', signal } = options;
  const place = thread === 'main' ? undefined : await slotInWorker(thread);
  if (place) {
    if (signal?.aborted) place.leave();
    signal?.throwIfAborted();
    const canvas = makeCanvas();
    try {
      return following(canvas, await place.open(canvas, options));
    } catch (error) {
      if (thread === 'worker' || !(error instanceof UnsupportedError || error instanceof ContextError)) throw error;
    }
  }
  // With three.js and all that draws: pages whose smoke runs in a worker never fetch it themselves.
  const { openHere } = await fetched('The smoke', import('./openHere.ts'));
  signal?.throwIfAborted();
  const canvas = makeCanvas();
  return following(canvas, await openHere(canvas, options));
}

/** @throws where there has to be a worker and is none */
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

/** The stage, which rests while nobody can see it. */
function following(canvas: HTMLCanvasElement, stage: RemoteStage): RemoteStage {
  const stopFollowing = followSight(canvas, stage);
  return {
    ...stage,
    dispose() {
      stopFollowing();
      return stage.dispose();
    },
  };
}

/** Drawing begins so many pixels before the canvas comes into view. */
const MARGIN = '64px';

/**
 * Lets a stage rest while its canvas is out of view or its page is hidden. What somebody paused stays paused.
 * @returns the function that ends this
 */
function followSight(canvas: HTMLCanvasElement, stage: Pick<RemoteStage, 'setVisible'>): () => void {
  const page = canvas.ownerDocument;
  let isNear = true;
  let notified = true;
  const notify = () => {
    const isVisible = isNear && !page.hidden;
    if (isVisible === notified) return;
    notified = isVisible;
    // A stage that has ended meanwhile refuses, and needs to know no more.
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
