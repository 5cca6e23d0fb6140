import type { LoadError } from '../base/errors.ts';
import { fetchExtras, hasExtras, type PictureKind } from './extraPasses.ts';

export interface Completion {
  /**
   * Resolves when the next picture can be drawn as its settings require. A failed load is retried on the next call.
   * @throws LoadError if the code cannot be loaded
   */
  wait(): Promise<void>;
  /** Starts loading without a promise for the caller. Errors are reported only while the code is still needed. */
  begin(): void;
}

/**
 * Loads the code that pictures need and that is not loaded yet. Concurrent calls share one request.
 * @param wanted returns the settings of the pictures
 * @param show called after code was loaded
 * @param miss called once with the error of a load that was started by `begin`
 */
export function completionOf(
  wanted: () => readonly PictureKind[],
  show: () => void,
  miss: (error: LoadError) => void,
): Completion {
  let fetching: Promise<void> | undefined;
  let notifying: Promise<void> | undefined;
  const isComplete = () => wanted().every(hasExtras);
  const fetchMissing = async () => {
    while (!isComplete()) {
      await Promise.all(wanted().map(fetchExtras));
      show();
    }
  };
  const wait = () => (fetching ??= fetchMissing().finally(() => (fetching = undefined)));
  const notify = (error: LoadError) => (isComplete() ? undefined : miss(error));
  const begin = () => {
    if (!isComplete())
      notifying ??= wait()
        .catch(notify)
        .finally(() => (notifying = undefined));
  };
  return { wait, begin };
}
