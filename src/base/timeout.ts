/** Downloads with timeouts. */
import { LoadError } from './errors.ts';

const TIMEOUT_MS = 60_000;
const TICK_MS = 1_000;

/**
 * Calls back after this thread has run for a duration. Time in system sleep, in a throttled tab or at a breakpoint
 * counts as one tick at most, so that a request does not time out while nothing can make progress.
 * @param milliseconds rounded up to whole seconds
 * @returns function that cancels the timeout
 */
export function afterRunning(milliseconds: number, act: () => void): () => void {
  let left = Math.ceil(milliseconds / TICK_MS);
  const end = () => clearInterval(timer);
  const timer = setInterval(() => {
    left -= 1;
    if (left > 0) return;
    end();
    act();
  }, TICK_MS);
  return end;
}

/**
 * Calls back with a timeout error after 60 s of running time.
 * @returns function that cancels the timeout
 */
export function whenLate(giveUp: (error: Error) => void): () => void {
  return afterRunning(TIMEOUT_MS, () => giveUp(new Error('no data for 60 s.')));
}

/**
 * Awaits a promise with a timeout of 60 s of running time.
 * @throws Error on timeout; otherwise the reason with which the promise rejects
 */
export function inTime<Value>(coming: Promise<Value>): Promise<Value> {
  return new Promise((resolve, reject) => {
    coming.then(resolve, reject).finally(whenLate(reject));
  });
}

/**
 * Awaits a download, such as a dynamic import, with a timeout. A module that arrives after the timeout is cached by the
 * browser, so a retry succeeds immediately.
 * @param what subject of the error message
 * @throws LoadError if the download fails or times out
 */
export async function fetched<Value>(what: string, coming: Promise<Value>): Promise<Value> {
  try {
    return await inTime(coming);
  } catch (cause) {
    throw new LoadError(`${what} could not be loaded: ${(cause as Error).message}`, { cause });
  }
}

type Imports = Readonly<Record<string, () => Promise<object>>>;
type Modules<Some extends Imports> = { readonly [Name in keyof Some]: Awaited<ReturnType<Some[Name]>> };

/** Modules that are loaded on first use and shared by the whole thread. */
export class LazyModules<Some extends Imports> {
  readonly loaded: Partial<Modules<Some>> = {};
  private readonly imports: Some;

  constructor(imports: Some) {
    this.imports = imports;
  }

  /**
   * Loads a module, or returns the loaded one. A failed load is retried on the next call.
   * @param what subject of the error message
   * @throws LoadError if the module cannot be loaded
   */
  async load<Name extends keyof Some>(name: Name, what: string): Promise<Modules<Some>[Name]> {
    return (this.loaded[name] ??= await fetched(what, this.imports[name]() as Promise<Modules<Some>[Name]>));
  }
}
