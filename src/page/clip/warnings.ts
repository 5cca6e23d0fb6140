/** Warnings about `clip()`: a missing `await`, and failures. */
import { warnOfError, warnUnawaited } from '../../base/warn.ts';
import type { clip } from './clip.ts';

const ABOUT = 'clip()';
/** What programs use of a file. */
const MEMBERS = ['size', 'type', 'arrayBuffer', 'stream', 'text', 'slice'];

/** @returns a function that does what the given one does, with warnings */
export function watch(production: typeof clip): typeof clip {
  return (smoke, options) => {
    const work = production(smoke, options);
    work.catch((error: Error) => options?.signal?.aborted || warnOfError(ABOUT, error));
    return warnUnawaited(ABOUT, work, MEMBERS);
  };
}
