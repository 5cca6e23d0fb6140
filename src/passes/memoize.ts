/**
 * A computation whose result is kept for as long as what it was made of: smokes that show the same surfaces share it.
 * @param compute reads its argument and changes nothing
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
