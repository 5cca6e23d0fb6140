import { finished, type Work } from '../../base/work.ts';

/**
 * Memoizes a function by the identity of its argument, in a WeakMap, so that smokes with the same surfaces share
 * results.
 * @param compute a pure function
 */
export function memoize<Source extends object, Result>(
  compute: (source: Source) => Result,
): (source: Source) => Result {
  const results = new WeakMap<Source, Result>();
  return (source) => {
    if (!results.has(source)) results.set(source, compute(source));
    return results.get(source)!;
  };
}

/** Like {@link memoize}, for a function that can also run in pieces: `pieces` yields, and the function does not. */
export function memoizeWork<Source extends object, Result>(compute: (source: Source) => Work<Result>) {
  const results = new WeakMap<Source, Result>();
  function* pieces(source: Source): Work<Result> {
    if (!results.has(source)) results.set(source, yield* compute(source));
    return results.get(source)!;
  }
  return Object.assign((source: Source) => finished(pieces(source)), { pieces });
}
