import { LoadError } from './errors.ts';
import { afterRunning, PATIENCE_MS } from './patience.ts';

/**
 * What is on its way, such as a module. Should it come later than this waits, whoever asks again has it at once.
 * @param what begins the sentence of the error
 * @throws LoadError when it cannot be had, or when nothing has come for a minute in which this thread ran
 */
export async function fetched<Value>(what: string, coming: Promise<Value>): Promise<Value> {
  try {
    return await inTime(coming);
  } catch (cause) {
    throw new LoadError(`${what} could not be fetched: ${(cause as Error).message}`, { cause });
  }
}

/** @throws Error when it does not come; what it rejects with */
export function inTime<Value>(coming: Promise<Value>): Promise<Value> {
  return new Promise((resolve, reject) => {
    const stop = afterRunning(PATIENCE_MS, () => reject(new Error('nothing has come for a minute.')));
    coming.then(resolve, reject).finally(stop);
  });
}
