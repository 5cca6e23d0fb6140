/** Maps rejections from the simulator to errors of the library. */
import { ParameterError, SimulatorError } from '../base/errors.ts';

/** A rejected call, as thrown by the Rust side. */
export interface SimulatorRejection {
  /** Key of the parameter; empty if the rejection concerns no parameter. */
  readonly key: string;
  readonly value: number;
  /** Valid range if `min` <= `max`; otherwise `message` describes what is valid. */
  readonly min: number;
  readonly max: number;
  readonly message: string;
}

/** Whether the error is a rejected call and not a fault. */
export function isSimulatorRejection(error: unknown): error is SimulatorRejection {
  return typeof error === 'object' && error !== null && 'key' in error && 'message' in error;
}

/** The public error for a rejection: ParameterError if it has a key, otherwise SimulatorError. */
export function errorOfSimulator(rejection: SimulatorRejection): Error {
  if (rejection.key === '') return new SimulatorError(rejection.message);
  const { key, value, min, max, message } = rejection;
  if (key === LOOK) return new ParameterError(key, value, TOO_MANY_LOOKS);
  return new ParameterError(key, value, min <= max ? `a number from ${min} to ${max}` : message);
}

/** Key of the rejection of a look too many, and what it takes. */
const LOOK = 'look';
const TOO_MANY_LOOKS =
  'at most 15 different looks of emitters and of their puffs at a time; another one once all puffs of one are gone';

/** Names the call in the error of a look too many. */
export function namingLook<Result>(call: string, act: () => Result): Result {
  try {
    return act();
  } catch (error) {
    if (error instanceof ParameterError && error.key === LOOK)
      throw new ParameterError(`${call}.${LOOK}`, error.value, error.accepted);
    throw error;
  }
}
