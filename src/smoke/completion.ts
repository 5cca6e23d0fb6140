import type { LoadError } from '../preset/errors.ts';
import { fetchExtras, hasExtras, type PictureKind } from './extraPasses.ts';

export interface Completion {
  /**
   * Settled when the next picture is drawn as it is asked for. What could not be fetched is tried anew.
   * @throws LoadError when it cannot be fetched
   */
  wait(): Promise<void>;
  /** The same where nobody waits for it; what nobody wants any longer is not missed. */
  begin(): void;
}

/**
 * Brings what pictures need as they are asked for and is not here: all at once, however many wait for it.
 * @param wanted how pictures are asked for now
 * @param show called when something has come
 * @param miss called with why something cannot be had, once, where nobody waits for it
 */
export function completionOf(
  wanted: () => PictureKind,
  show: () => void,
  miss: (error: LoadError) => void,
): Completion {
  let fetching: Promise<void> | undefined;
  let notifying: Promise<void> | undefined;
  const isComplete = () => hasExtras(wanted());
  const fetchMissing = async () => {
    while (!isComplete()) {
      await fetchExtras(wanted());
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
