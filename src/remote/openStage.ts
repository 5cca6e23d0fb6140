import type { RemoteStage, RemoteStageOptions } from './contract.ts';
import { followSight } from './followSight.ts';
import { openHere } from './openHere.ts';

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
  const canvas = makeCanvas();
  const stage = await openHere(canvas, options);
  return following(canvas, stage);
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
