/** What the page asks of its worker now and then, and the worker says at once. */
export const BEAT = 'beat';

const BEAT_MS = 10_000;
/** Two minutes: a busy machine answers late, and who is gone never does. */
const MAX_MISSED = 12;

/** What a worker has to be there for. */
export interface Watched {
  readonly worker: Pick<Worker, 'postMessage' | 'addEventListener' | 'removeEventListener'>;
  /** Called once that it does not answer any more. */
  readonly onGone: () => void;
}

/**
 * Finds out that a worker is gone: browsers may end one without a word, as for want of memory. What counts are beats while the
 * page runs in view, and not seconds: a laptop that sleeps, a hidden tab and a debugger's break have no beats. A
 * worker that is itself held by a debugger for so long is as silent as one that is gone, and is given up.
 * @returns the function that ends this
 */
export function watchHeart({ worker, onGone }: Watched): () => void {
  let missed = 0;
  const end = () => {
    clearInterval(timer);
    worker.removeEventListener('message', live);
  };
  const live = () => void (missed = 0);
  const beat = () => {
    // Browsers may let the workers of hidden pages rest.
    if (document.hidden) return live();
    if (missed >= MAX_MISSED) {
      end();
      return onGone();
    }
    missed += 1;
    worker.postMessage(BEAT);
  };
  const timer = setInterval(beat, BEAT_MS);
  worker.addEventListener('message', live);
  return end;
}

/**
 * Lets a worker say that it lives where it has no time to listen.
 * @param beat says so
 * @returns what to call often; it says so now and then
 */
export function beatWhile(beat: () => void): () => void {
  let latest = performance.now();
  return () => {
    const now = performance.now();
    if (now - latest < BEAT_MS) return;
    latest = now;
    beat();
  };
}
