/** A promise that is settled from outside. A rejection that nobody awaits is not reported as unhandled. */
export class Deferred<Value> {
  resolve!: (value: Value) => void;
  reject!: (error: Error) => void;
  readonly promise = new Promise<Value>((resolve, reject) => {
    this.resolve = resolve;
    this.reject = reject;
  });

  constructor() {
    ignoreRejection(this.promise);
  }
}

/**
 * Marks a rejection as handled, for work whose failure is reported elsewhere (by the stage's `error` event) or follows
 * from disposal. The library does not write to the page's console.
 */
export function ignoreRejection(work: Promise<unknown>): void {
  work.catch(() => undefined);
}
