import { LoadError, SimulatorError } from '../preset/errors.ts';
import { afterRunning } from '../preset/timeout.ts';
import { watchHeart } from './heartbeat.ts';
import type { Greeting } from './worker.ts';
import { unpackError } from './packedErrors.ts';
import { startWorker } from './startWorker.ts';

/** Until then a worker has to have come and said that it can draw; time in which the page runs. */
const GREETING_MS = 30_000;
/** A worker that ends more often than this ends by what is drawn, and would do so for ever. */
const MAX_DEATHS = 3;
/** Who comes back soon, as on a page that moves its widgets about, finds the worker as it was. */
const GRACE_MS = 5_000;

/** A stage in the worker. */
export interface Holder {
  /** Called when the worker has ended; it is held no more then. */
  fail(error: Error): void;
}

/** The worker that all stages of a page share: started for the first, ended some time after the last. */
class PageWorker {
  private starting: Promise<Worker> | undefined;
  private worker: Worker | undefined;
  private holders = new Set<Holder>();
  private deaths = 0;
  private farewell: ReturnType<typeof setTimeout> | undefined;
  private failure: Error | undefined;
  private stopWatching: (() => void) | undefined;

  /**
   * The worker, which the same holder has to release. Where it could not be had, or has ended three times, it is not tried
   * again.
   * @throws why it cannot be had
   */
  async hold(holder: Holder): Promise<Worker> {
    if (this.failure) throw this.failure;
    clearTimeout(this.farewell);
    this.holders.add(holder);
    this.starting ??= this.start();
    try {
      return await this.starting;
    } catch (error) {
      this.failure = error as Error;
      this.holders.delete(holder);
      throw error;
    }
  }

  release(holder: Holder): void {
    if (this.holders.delete(holder) && this.holders.size === 0) {
      this.farewell = setTimeout(() => this.end(), GRACE_MS);
    }
  }

  /** Tells whoever holds a worker that it is no more. Of one that is not the page's any longer there is nothing to tell. */
  private lose(worker: Worker, message: string): void {
    if (worker !== this.worker) return;
    const error = new SimulatorError(message);
    const holders = [...this.holders];
    this.holders.clear();
    this.end();
    this.deaths += 1;
    if (this.deaths >= MAX_DEATHS) this.failure = error;
    for (const holder of holders) holder.fail(error);
  }

  private async start(): Promise<Worker> {
    const worker = startWorker();
    try {
      await greeted(worker);
    } catch (error) {
      worker.terminate();
      throw error;
    }
    worker.onmessage = null;
    worker.onerror = (event) => {
      // It is told to the stages, and not to the page as one of its own.
      event.preventDefault();
      this.lose(worker, `The worker failed: ${event.message}`);
    };
    this.stopWatching = watchHeart({
      worker,
      onGone: () => this.lose(worker, 'The worker stopped responding.'),
    });
    this.worker = worker;
    return worker;
  }

  private end(): void {
    this.stopWatching?.();
    this.worker?.terminate();
    this.worker = this.starting = undefined;
  }
}

/** Settled when a worker says whether it can draw, does not come, or keeps silent for too long. */
function greeted(worker: Worker): Promise<void> {
  return new Promise((resolve, reject) => {
    const fail = (reason: string) => reject(new LoadError(`The worker could not be started: ${reason}`));
    const stopWaiting = afterRunning(GREETING_MS, () => fail('it did not answer in time.'));
    worker.onerror = (event) => {
      event.preventDefault();
      stopWaiting();
      fail(event.message ?? 'the page or the browser does not allow it.');
    };
    worker.onmessage = ({ data }: MessageEvent<Greeting>) => {
      stopWaiting();
      const error = unpackError(data.error);
      if (error) reject(error);
      else resolve();
    };
  });
}

export const pageWorker = new PageWorker();
