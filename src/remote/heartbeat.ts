/** What the page asks of its worker now and then, and the worker says at once. */
export const BEAT = 'beat';

const BEAT_MS = 10_000;
/** A worker that takes thousands of steps answers late, by a minute on a busy machine; one that is gone never does. */
const MOST_MISSED = 12;

/**
 * Finds out that a worker is gone: browsers may end one without a word, as for want of memory. Beats are counted and not
 * seconds, because a page that sleeps has no answers either.
 * @param tell told once that it does not answer any more
 * @returns the function that ends this
 */
export function watchHeart(worker: Worker, tell: () => void): () => void {
  let missed = 0;
  const end = () => {
    clearInterval(timer);
    worker.removeEventListener('message', live);
  };
  const live = () => (missed = 0);
  const beat = () => {
    if (missed >= MOST_MISSED) {
      end();
      return tell();
    }
    missed += 1;
    worker.postMessage(BEAT);
  };
  const timer = setInterval(beat, BEAT_MS);
  worker.addEventListener('message', live);
  return end;
}
