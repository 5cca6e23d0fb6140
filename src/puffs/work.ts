/** Work in pieces of a millisecond or so, so that pictures can be drawn in between; its result comes at the end. */
export type Work<Result> = Generator<void, Result, void>;

/** Does all of it at once. */
export function finished<Result>(work: Work<Result>): Result {
  for (;;) {
    const { done, value } = work.next();
    if (done) return value;
  }
}

/** Spent at a time: a page goes on answering in between. */
const PIECE_MS = 16;

/** Does it while the page goes on: other tasks have their turn when so many milliseconds are over, or with each piece at 0. */
export async function inPieces<Result>(work: Work<Result>, milliseconds = PIECE_MS): Promise<Result> {
  for (;;) {
    const until = performance.now() + milliseconds;
    do {
      const { done, value } = work.next();
      if (done) return value;
    } while (performance.now() < until);
    await new Promise((resolve) => setTimeout(resolve));
  }
}

/** Goes on for some milliseconds, at least one piece. Undefined while there is more to do. */
export function workedFor<Result>(work: Work<Result>, milliseconds: number): Result | undefined {
  const until = performance.now() + milliseconds;
  do {
    const { done, value } = work.next();
    if (done) return value;
  } while (performance.now() < until);
  return undefined;
}
