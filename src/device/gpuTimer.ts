import type { Device } from './device.ts';

interface TimerExtension {
  readonly TIME_ELAPSED_EXT: number;
  readonly GPU_DISJOINT_EXT: number;
}

/**
 * Times frames on the GPU, where the browser has EXT_disjoint_timer_query_webgl2. A result takes several frames, and the
 * frames until then are not timed.
 */
export class GpuTimer {
  /** Milliseconds of the latest frame with a result. */
  milliseconds: number | undefined;
  private readonly context: WebGL2RenderingContext;
  private readonly stopListening: () => void;
  private query: WebGLQuery | undefined;

  constructor(device: Device) {
    this.context = device.renderer.getContext() as WebGL2RenderingContext;
    // A query belongs to the context before its loss.
    this.stopListening = device.onContext(() => (this.query = undefined));
  }

  /** Calls `draw`, whose commands are timed if no other result is pending. */
  time(draw: () => void): void {
    const { context } = this;
    const timer = context.getExtension('EXT_disjoint_timer_query_webgl2') as TimerExtension | null;
    if (timer) this.read(timer);
    if (!timer || this.query) return draw();
    const query = context.createQuery();
    context.beginQuery(timer.TIME_ELAPSED_EXT, query);
    try {
      draw();
    } finally {
      context.endQuery(timer.TIME_ELAPSED_EXT);
      this.query = query;
    }
  }

  dispose(): void {
    this.stopListening();
    if (this.query) this.context.deleteQuery(this.query);
    this.query = undefined;
  }

  private read({ GPU_DISJOINT_EXT }: TimerExtension): void {
    const { context, query } = this;
    if (!query || !context.getQueryParameter(query, context.QUERY_RESULT_AVAILABLE)) return;
    // The GPU has changed its clock.
    if (!context.getParameter(GPU_DISJOINT_EXT)) {
      this.milliseconds = (context.getQueryParameter(query, context.QUERY_RESULT) as number) / 1e6;
    }
    context.deleteQuery(query);
    this.query = undefined;
  }
}
