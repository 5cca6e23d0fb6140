import { LoadError, SmokeError } from '../base/errors.ts';

/** Converts any error to a SmokeError of the library. */
export function asSmokeError(error: unknown): SmokeError {
  if (error instanceof SmokeError) return error;
  return new LoadError(`The smoke stopped: ${(error as Error).message}`, { cause: error });
}
