/** How long what is on its way is waited for. */
import { LoadError } from './errors.ts';

const TIMEOUT_MS = 60_000;
const TICK_MS = 1_000;

/**
 * Calls back once this thread has run for so long. A laptop that slept, a tab whose timers rest and a debugger's break make
 * one tick late and not many of them, so that nobody is given up for a time in which nothing could happen.
 * @param milliseconds rounded up to whole seconds
 * @returns the function that ends the waiting
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
 * Calls back when nothing has come for a minute in which this thread ran: then it does not come.
 * @returns the function that ends the waiting
 */
export function whenLate(giveUp: (error: Error) => void): () => void {
  return afterRunning(TIMEOUT_MS, () => giveUp(new Error('no data for 60 s.')));
}

/** @throws Error when it does not come within a minute in which this thread runs; what it rejects with */
export function inTime<Value>(coming: Promise<Value>): Promise<Value> {
  return new Promise((resolve, reject) => {
    coming.then(resolve, reject).finally(whenLate(reject));
  });
}

/**
 * What is on its way, such as a module. Should it come later than this waits, whoever asks again has it at once.
 * @param what begins the sentence of the error
 * @throws LoadError when it cannot be had, or does not come in time
 */
export async function fetched<Value>(what: string, coming: Promise<Value>): Promise<Value> {
  try {
    return await inTime(coming);
  } catch (cause) {
    throw new LoadError(`${what} could not be fetched: ${(cause as Error).message}`, { cause });
  }
}
