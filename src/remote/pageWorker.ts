import { LoadError, SimulatorError } from '../preset/errors.ts';
import { watchHeart } from './heartbeat.ts';
import type { Greeting } from './worker.ts';
import { unpackError } from './packedErrors.ts';
import { startWorker } from './startWorker.ts';

/** Until then a worker has to have come and said that it can draw. */
const GREETING_MS = 30_000;
/** Who comes back soon, as on a page that moves its widgets about, finds the worker as it was. */
const GRACE_MS = 5_000;

/** The worker that all stages of a page share: started for the first, ended some time after the last. */
class PageWorker {
  private starting: Promise<Worker> | undefined;
  private worker: Worker | undefined;
  private holders = new Set<(error: Error) => void>();
  private farewell: ReturnType<typeof setTimeout> | undefined;
  private refusal: Error | undefined;
  private stopWatching: (() => void) | undefined;

  /**
   * The worker, which has to be released with the same function. Where it could not be had or failed once, it is not tried
   * again.
   * @param onFailure told when the worker fails later
   * @throws why it cannot be had
   */
  async hold(onFailure: (error: Error) => void): Promise<Worker> {
    if (this.refusal) throw this.refusal;
    clearTimeout(this.farewell);
    this.holders.add(onFailure);
    this.starting ??= this.start();
    try {
      return await this.starting;
    } catch (error) {
      this.refusal = error as Error;
      this.holders.delete(onFailure);
      throw error;
    }
  }

  release(onFailure: (error: Error) => void): void {
    if (this.holders.delete(onFailure) && this.holders.size === 0) {
      this.farewell = setTimeout(() => this.end(), GRACE_MS);
    }
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
      this.fail(`The worker failed: ${event.message}`);
    };
    this.stopWatching = watchHeart(worker, () => this.fail('The worker is gone: it does not answer any more.'));
    this.worker = worker;
    return worker;
  }

  private fail(message: string): void {
    this.end();
    this.refusal = new SimulatorError(message);
    for (const holder of this.holders) holder(this.refusal);
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
    const refuse = (reason: string) => reject(new LoadError(`The worker could not be started: ${reason}`));
    const timer = setTimeout(() => refuse('it did not answer in time.'), GREETING_MS);
    worker.onerror = (event) => {
      event.preventDefault();
      clearTimeout(timer);
      refuse(event.message ?? 'the page or the browser does not allow it.');
    };
    worker.onmessage = ({ data }: MessageEvent<Greeting>) => {
      clearTimeout(timer);
      const error = unpackError(data.error);
      if (error) reject(error);
      else resolve();
    };
  });
}

export const pageWorker = new PageWorker();
