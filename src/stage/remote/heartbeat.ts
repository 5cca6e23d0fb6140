/** The ping that the page sends to its worker, and the worker's reply. */
export const BEAT = 'beat';

const BEAT_MS = 10_000;
/** Two minutes: a busy machine may reply late. */
const MAX_MISSED = 12;

/** The worker to monitor. */
export interface Watched {
  readonly worker: Pick<Worker, 'postMessage' | 'addEventListener' | 'removeEventListener'>;
  /** Called once when the worker stops responding. */
  readonly onGone: () => void;
}

/**
 * Detects a terminated worker: browsers may end one without an event, for example when memory runs out. It counts
 * missed beats while the page is visible, not seconds, because sleep, hidden tabs and debugger pauses suspend the
 * beats. A worker that a debugger pauses for that long is also treated as gone.
 * @returns a function that stops the heartbeat
 */
export function watchHeart({ worker, onGone }: Watched): () => void {
  let missed = 0;
  const end = () => {
    clearInterval(timer);
    worker.removeEventListener('message', live);
  };
  const live = () => void (missed = 0);
  const beat = () => {
    // Browsers may suspend the workers of hidden pages.
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
 * Sends heartbeats during long tasks that block the worker's event loop.
 * @param beat sends a heartbeat
 * @returns a function to call often; it throttles the heartbeats
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
