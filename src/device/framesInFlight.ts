import type { Device } from './device.ts';

/** The GPU draws one frame while it is told the next; more would only make what is seen older. */
const MAX_FRAMES = 2;

/**
 * Frames that were handed to the GPU and are not drawn yet. Browsers hold animation frames back for a GPU that falls behind
 * as long as they show the canvas; beside the viewport they do not, and the whole page would wait behind what piles up.
 */
export class FramesInFlight {
  private readonly context: WebGL2RenderingContext;
  private fences: WebGLSync[] = [];

  constructor({ renderer }: Device) {
    this.context = renderer.getContext() as WebGL2RenderingContext;
  }

  /** Whether the next frame had better wait. */
  get isFull(): boolean {
    while (this.fences.length > 0 && this.isDrawn(this.fences[0])) this.context.deleteSync(this.fences.shift()!);
    return this.fences.length >= MAX_FRAMES;
  }

  /** A frame has just been handed over. */
  add(): void {
    const { context } = this;
    const fence = context.fenceSync(context.SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (!fence) return;
    this.fences.push(fence);
    // Until then it is not even on its way.
    context.flush();
  }

  /** The context has gone, and they with it. */
  clear(): void {
    this.fences = [];
  }

  private isDrawn(fence: WebGLSync): boolean {
    return this.context.getSyncParameter(fence, this.context.SYNC_STATUS) !== this.context.UNSIGNALED;
  }
}
