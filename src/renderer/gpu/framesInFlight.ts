import type { WebGLRenderer } from 'three';

/** The GPU draws one frame while the next is submitted. More frames in flight only add latency. */
const MAX_FRAMES = 2;
const POLL_MS = 5;
const TIMEOUT_MS = 10_000;

/**
 * Limits the frames that are submitted to the GPU and not finished. Browsers throttle animation frames for a slow GPU
 * only while the canvas is visible. Outside of the viewport they do not, and the whole page would wait for the queued
 * frames.
 */
export class FramesInFlight {
  private readonly context: WebGL2RenderingContext;
  private fences: WebGLSync[] = [];

  constructor({ renderer }: { readonly renderer: WebGLRenderer }) {
    this.context = renderer.getContext() as WebGL2RenderingContext;
  }

  /** Whether the next frame should wait. */
  get isFull(): boolean {
    while (this.fences.length > 0 && hasPassed(this.context, this.fences[0]))
      this.context.deleteSync(this.fences.shift()!);
    return this.fences.length >= MAX_FRAMES;
  }

  /** Call after the commands of a frame are submitted. */
  add(): void {
    const fence = placeFence(this.context);
    if (fence) this.fences.push(fence);
  }

  /** Forgets all frames after a context loss, which invalidates their fences. */
  clear(): void {
    this.fences = [];
  }
}

/** A fence behind all commands so far; null if the context is lost. */
export function placeFence(context: WebGL2RenderingContext): WebGLSync | null {
  const fence = context.fenceSync(context.SYNC_GPU_COMMANDS_COMPLETE, 0);
  // The fence is not sent to the GPU before a flush.
  context.flush();
  return fence;
}

/** Whether the GPU has executed the commands before the fence. Does not wait for it. */
export function hasPassed(context: WebGL2RenderingContext, fence: WebGLSync): boolean {
  return context.getSyncParameter(fence, context.SYNC_STATUS) !== context.UNSIGNALED;
}

/**
 * Resolves when the GPU has executed all commands so far, without blocking; false after 10 s or if the context is lost.
 * @param isDone what else to wait for
 */
export async function executed(context: WebGL2RenderingContext, isDone = () => true): Promise<boolean> {
  const fence = placeFence(context);
  const until = performance.now() + TIMEOUT_MS;
  while (!context.isContextLost() && performance.now() < until) {
    if (hasPassed(context, fence!) && isDone()) return true;
    await new Promise((resolve) => setTimeout(resolve, POLL_MS));
  }
  return false;
}
