import { LoadError, SimulatorError } from '../../base/errors.ts';
import { afterRunning } from '../../base/timeout.ts';
import { watchHeart } from './heartbeat.ts';
import type { Greeting } from './worker.ts';
import { unpackError } from './packedErrors.ts';
import { assetUrl, servedUrl } from '../../base/assetUrls.ts';

/** Timeout for the worker's greeting. Counts only time in which the page runs. */
const GREETING_MS = 30_000;
/** A worker that fails this often probably fails because of what it draws, so it is not restarted. */
const MAX_DEATHS = 3;
/** Keeps the worker alive for stages that are soon reopened, for example when a page moves its widgets. */
const GRACE_MS = 5_000;

/** A stage in the worker. */
export interface Holder {
  /** Called when the worker has ended; the holder is released then. */
  fail(error: Error): void;
}

/** The worker shared by all stages of a page. It starts with the first stage and ends some time after the last. */
class PageWorker {
  private starting: Promise<Worker> | undefined;
  private worker: Worker | undefined;
  private holders = new Set<Holder>();
  private deaths = 0;
  private shutdownTimer: ReturnType<typeof setTimeout> | undefined;
  private failure: Error | undefined;
  private stopWatching: (() => void) | undefined;

  /**
   * Returns the worker. The same holder must release it. After a failed start, or after three failures, it is not
   * started again.
   * @throws the reason why no worker is available
   */
  async acquire(holder: Holder): Promise<Worker> {
    if (this.failure) throw this.failure;
    clearTimeout(this.shutdownTimer);
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

  release(holder: Holder, graceMs = GRACE_MS): void {
    if (this.holders.delete(holder) && this.holders.size === 0) {
      this.shutdownTimer = setTimeout(() => this.end(), graceMs);
    }
  }

  /** Notifies all holders that the worker has ended. Ignored for a worker that was already replaced. */
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
      // The error is reported to the stages and must not become an uncaught error of the page.
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

/** Settles when the worker reports whether it can draw, fails to start, or times out. */
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

/** The policy name that the page's `trusted-types` directive must allow. */
const POLICY = 'cartoon-smoke';

/** Missing from TypeScript's DOM library. */
interface TrustedTypes {
  createPolicy(
    name: string,
    rules: { createScriptURL(address: string): string },
  ): {
    createScriptURL(address: string): string;
  };
}

/** Bundlers detect workers only in this literal form. */
function start(): Worker {
  return new Worker(new URL('./worker.ts', import.meta.url), { type: 'module', name: 'cartoon-smoke' });
}

/** Its URL where no bundler has moved it. Not `new URL` with two arguments, whose file bundlers would copy once more. */
function addressBeside(): string {
  return new URL(import.meta.url.replace(/[^/]*$/, './worker.ts')).href;
}

/**
 * Starts the module of `worker.ts`.
 * @throws when the page's security policy blocks it at once. If it is blocked later or cannot be fetched, the worker
 * emits an error event
 */
export function startWorker(): Worker {
  const own = assetUrl('worker');
  if (own) return startFrom(own);
  const address = addressBeside();
  const served = servedUrl(address);
  if (served !== address) return startFrom(served);
  try {
    return start();
  } catch {
    return startFrom(address);
  }
}

function startFrom(address: string): Worker {
  return new Worker(trusted(sameOrigin(address)), { type: 'module', name: 'cartoon-smoke' });
}

/**
 * Browsers require a same-origin worker script. A same-origin blob can import a cross-origin module, for example from a
 * CDN.
 */
function sameOrigin(address: string): string {
  if (new URL(address, location.href).origin === location.origin) return address;
  return URL.createObjectURL(new Blob([`import ${JSON.stringify(address)};`], { type: 'text/javascript' }));
}

/**
 * Converts a URL for pages that require Trusted Types.
 * @throws TypeError when the page does not allow the policy name
 */
function trusted(address: string): string {
  const { trustedTypes } = globalThis as { trustedTypes?: TrustedTypes };
  const policy = trustedTypes?.createPolicy(POLICY, { createScriptURL: (given) => given });
  return policy?.createScriptURL(address) ?? address;
}
