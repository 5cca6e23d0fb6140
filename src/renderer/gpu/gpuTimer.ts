import type { Device } from './device.ts';

/** Results arrive some frames later. Until then, further frames are not measured. */
const MAX_PENDING = 3;

/** Measures frames on the GPU. */
export interface GpuTimer {
  /** The time of the latest frame that has a result; undefined until there is one. */
  read(): { readonly gpuMs: number } | undefined;
  /** Call before the commands of a frame. Returns the function to call after them. */
  begin(): (() => void) | undefined;
  dispose(): void;
}

interface TimerExtension {
  readonly TIME_ELAPSED_EXT: number;
  readonly GPU_DISJOINT_EXT: number;
}

interface Pending {
  readonly query: WebGLQuery;
  readonly timer: GpuTimer;
  readonly finish: (milliseconds: number) => void;
}

/** Queries without a result, oldest first. The timers of a context share them, because reading its disjoint flag resets it. */
const pendingOf = new WeakMap<WebGL2RenderingContext, Pending[]>();

/**
 * A timer that uses EXT_disjoint_timer_query_webgl2 and never waits: results are read when they are available. Without
 * the extension it does nothing.
 */
export function createGpuTimer(device: Pick<Device, 'renderer' | 'onContext'>): GpuTimer {
  const context = device.renderer.getContext() as WebGL2RenderingContext;
  const pending = pendingOf.get(context) ?? [];
  pendingOf.set(context, pending);
  let extension: TimerExtension | null = null;
  let time: { readonly gpuMs: number } | undefined;

  const drop = (isDropped: (each: Pending) => boolean) => {
    for (const each of pending.filter(isDropped)) {
      context.deleteQuery(each.query);
      pending.splice(pending.indexOf(each), 1);
    }
  };
  const start = () => {
    extension = context.getExtension('EXT_disjoint_timer_query_webgl2') as TimerExtension | null;
  };
  const timer: GpuTimer = {
    read() {
      while (pending[0] && context.getQueryParameter(pending[0].query, context.QUERY_RESULT_AVAILABLE)) {
        // The GPU changed its clock or was interrupted, so none of the times is valid.
        if (context.getParameter(extension!.GPU_DISJOINT_EXT)) {
          drop(() => true);
          break;
        }
        const { query, finish } = pending.shift()!;
        finish((context.getQueryParameter(query, context.QUERY_RESULT) as number) / 1e6);
        context.deleteQuery(query);
      }
      return time;
    },
    begin() {
      timer.read();
      if (!extension || pending.filter((each) => each.timer === timer).length >= MAX_PENDING) return undefined;
      const query = context.createQuery();
      const { TIME_ELAPSED_EXT } = extension;
      context.beginQuery(TIME_ELAPSED_EXT, query);
      pending.push({ query, timer, finish: (gpuMs) => (time = { gpuMs }) });
      return () => context.endQuery(TIME_ELAPSED_EXT);
    },
    dispose() {
      stopListening();
      drop((each) => each.timer === timer);
    },
  };
  // A lost context loses its queries and its extensions.
  const stopListening = device.onContext(() => {
    drop(() => true);
    start();
  });
  start();
  return timer;
}
