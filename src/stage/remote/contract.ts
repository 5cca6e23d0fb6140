import type { StageEvents, StageOptions } from '../contract.ts';
import type { RemoteMethods } from './calls.ts';

/** Where a stage runs: on the main thread, in a worker, or in a page inside an iframe. */
export type Thread = 'main' | 'worker' | 'frame';

/** A stage that may run on another thread or in another page. */
export interface RemoteStage extends RemoteMethods {
  /** Resolves when the first picture is drawn. */
  readonly ready: Promise<void>;
  readonly thread: Thread;
  /**
   * Adds an event listener. Events without a listener are not sent: only a 'frame' listener causes a message per frame.
   * @returns a function that removes the listener
   */
  on<Event extends keyof StageEvents>(event: Event, listener: (detail: StageEvents[Event]) => void): () => void;
  /** Releases all resources. Can be called more than once, and while calls are pending. */
  dispose(): Promise<void>;
}

export interface RemoteStageOptions extends Omit<
  StageOptions,
  'device' | 'failsSelfTest' | 'frameRate' | 'onStep' | 'turns'
> {
  /**
   * Where to run. Default: 'auto', a worker if the browser supports it and the page allows it, otherwise the main
   * thread.
   */
  thread?: 'auto' | 'main' | 'worker';
  /** Maximum frames per second while playing. Default: 60. */
  frameRate?: number;
  /** @internal Milliseconds that the worker stays after its last stage. */
  graceMs?: number;
  /** Aborts the start. The promise then rejects with the signal's reason, and all resources are released. */
  signal?: AbortSignal;
}
