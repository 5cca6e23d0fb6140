import { LoadError, SmokeError } from '../preset/errors.ts';

/** What went wrong, as one of the library's own errors. */
export function asSmokeError(error: unknown): SmokeError {
  if (error instanceof SmokeError) return error;
  return new LoadError(`The smoke stopped: ${(error as Error).message}`, { cause: error });
}
