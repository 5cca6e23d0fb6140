/** What the page asks of its worker now and then, and the worker says at once. */
export const BEAT = 'beat';

const BEAT_MS = 10_000;
/** Two minutes: a busy machine answers late, and who is gone never does. */
const MOST_MISSED = 12;
/** An hour: so long take as many steps as may be asked for at once, of as many particles as there may be. */
const MOST_MISSED_AT_WORK = 360;

/** What a worker has to be there for. */
export interface Watched {
  readonly worker: Pick<Worker, 'postMessage' | 'addEventListener' | 'removeEventListener'>;
  /** Whether it was asked for something that leaves no time for an answer. */
  readonly isAtWork: () => boolean;
  /** Told once that it does not answer any more. */
  readonly onGone: () => void;
}

/**
 * Finds out that a worker is gone: browsers may end one without a word, as for want of memory. What counts are beats while the
 * page runs in view, and not seconds: a laptop that sleeps, a hidden tab and a debugger's break have no beats.
 * @returns the function that ends this
 */
export function watchHeart({ worker, isAtWork, onGone }: Watched): () => void {
  let missed = 0;
  /** The latest of them, since it was at work. */
  let missedIdly = 0;
  const end = () => {
    clearInterval(timer);
    worker.removeEventListener('message', live);
  };
  const live = () => void (missed = missedIdly = 0);
  const beat = () => {
    // Browsers may let the workers of hidden pages rest.
    if (document.hidden) return live();
    if (isAtWork()) missedIdly = 0;
    if (missedIdly >= MOST_MISSED || missed >= MOST_MISSED_AT_WORK) {
      end();
      return onGone();
    }
    missed += 1;
    missedIdly += 1;
    worker.postMessage(BEAT);
  };
  const timer = setInterval(beat, BEAT_MS);
  worker.addEventListener('message', live);
  return end;
}
