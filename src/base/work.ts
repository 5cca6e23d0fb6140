/** Cooperative work: a generator that yields about every millisecond, so that frames can be drawn in between. */
export type Work<Result> = Generator<void, Result, void>;

/** Runs the work to completion synchronously. */
export function finished<Result>(work: Work<Result>): Result {
  for (;;) {
    const { done, value } = work.next();
    if (done) return value;
  }
}

/** Yields to the event loop without the minimum delay of nested timers. */
export function nextTask(): Promise<void> {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });
}

/** Slice length: half of a frame, and a short task even on a machine that is several times slower. */
export const PIECE_MS = 8;

/**
 * Runs the work asynchronously. Yields to the event loop after each slice.
 * @param milliseconds slice length; 0 yields after every step of the generator
 */
export async function inPieces<Result>(work: Work<Result>, milliseconds = PIECE_MS): Promise<Result> {
  for (;;) {
    const until = performance.now() + milliseconds;
    do {
      const { done, value } = work.next();
      if (done) return value;
    } while (performance.now() < until);
    await nextTask();
  }
}

/**
 * Runs the work for one slice, at least one step of the generator.
 * @returns the result, or undefined if the work is not finished
 */
export function workedFor<Result>(work: Work<Result>, milliseconds: number): Result | undefined {
  const until = performance.now() + milliseconds;
  do {
    const { done, value } = work.next();
    if (done) return value;
  } while (performance.now() < until);
  return undefined;
}

/** The same work, which throws the reason of a signal that is aborted. */
export function* unlessAborted<Result>(work: Work<Result>, signal: AbortSignal | undefined): Work<Result> {
  for (;;) {
    signal?.throwIfAborted();
    const { done, value } = work.next();
    if (done) return value;
    yield;
  }
}
