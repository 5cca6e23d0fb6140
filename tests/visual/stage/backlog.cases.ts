/** Frames that a stage has submitted to the GPU and that are not complete. */
import { lampStage, visibleCanvas } from './stage.cases.ts';

/**
 * Plays some frames below the viewport, where the browser does not throttle them.
 * @returns the largest number of incomplete frames
 */
export async function maxInFlight(frames: number): Promise<number> {
  const canvas = visibleCanvas();
  canvas.style.cssText = 'position: fixed; top: 110vh';
  const stage = await lampStage(canvas);
  const context = canvas.getContext('webgl2')!;
  let fences: WebGLSync[] = [];
  let most = 0;
  let played = 0;
  stage.play();
  await new Promise<void>((resolve) => {
    stage.on('frame', () => {
      fences = [...fences.filter((fence) => !isPassed(context, fence)), fenceIn(context)];
      most = Math.max(most, fences.length);
      if (++played === frames) resolve();
    });
  });
  stage.dispose();
  canvas.remove();
  return most;
}

function fenceIn(context: WebGL2RenderingContext): WebGLSync {
  const fence = context.fenceSync(context.SYNC_GPU_COMMANDS_COMPLETE, 0)!;
  context.flush();
  return fence;
}

function isPassed(context: WebGL2RenderingContext, fence: WebGLSync): boolean {
  return context.getSyncParameter(fence, context.SYNC_STATUS) === context.SIGNALED;
}
