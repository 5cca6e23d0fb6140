import { ignoreRejection } from './ignoreRejection.ts';

/** A promise that is settled from outside. Who waits for it hears of a failure; where nobody waits, nobody does. */
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
