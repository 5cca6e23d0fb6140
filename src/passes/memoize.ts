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
