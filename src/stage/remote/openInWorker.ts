import { assetUrls } from '../../base/assetUrls.ts';
import type { RemoteStage, RemoteStageOptions } from './contract.ts';
import { pageWorker, type Holder } from './pageWorker.ts';
import { PortStage } from './portStage.ts';
import type { OpenRequest } from './worker.ts';

/** Whether this browser can transfer a canvas to a worker. */
export function canMoveCanvas(): boolean {
  return typeof Worker !== 'undefined' && 'transferControlToOffscreen' in HTMLCanvasElement.prototype;
}

/** A started worker that can draw. */
export interface WorkerSlot {
  /**
   * Opens a stage on a canvas, which is permanently transferred to the worker.
   * @throws the errors of createStage
   */
  open(canvas: HTMLCanvasElement, options: RemoteStageOptions): Promise<RemoteStage>;
  leave(): void;
}

/** @throws the reason why this page has no worker */
export async function enterWorker(): Promise<WorkerSlot> {
  let stage: PortStage | undefined;
  let failure: Error | undefined;
  const holder: Holder = {
    fail(error) {
      failure = error;
      stage?.fail(error);
    },
  };
  const worker = await pageWorker.acquire(holder);
  const leave = (graceMs?: number) => pageWorker.release(holder, graceMs);
  return {
    leave: () => leave(),
    async open(canvas, { signal, onProgress, graceMs, ...options }) {
      if (failure) throw failure;
      const { port1, port2 } = new MessageChannel();
      const moved = canvas.transferControlToOffscreen();
      stage = new PortStage(port1, 'worker', () => leave(graceMs), onProgress);
      const values = options.values && { ...options.values };
      const request: OpenRequest = { canvas: moved, options: { ...options, values }, assets: assetUrls(), port: port2 };
      worker.postMessage(request, [moved, port2]);
      await unlessAborted(stage, signal);
      return stage.stage;
    },
  };
}

/** Waits until the stage is open. Disposes it when opening fails or is aborted. */
export async function unlessAborted(stage: PortStage, signal: AbortSignal | undefined): Promise<void> {
  const stop = () => void stage.stage.dispose();
  signal?.addEventListener('abort', stop);
  try {
    signal?.throwIfAborted();
    await stage.opened;
  } catch (error) {
    await stage.stage.dispose();
    throw signal?.aborted ? signal.reason : error;
  } finally {
    signal?.removeEventListener('abort', stop);
  }
}
