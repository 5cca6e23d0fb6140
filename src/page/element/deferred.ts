import { ignoreRejection } from './ignoreRejection.ts';

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
