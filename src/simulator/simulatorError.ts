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
  const ranged = rejection.min <= rejection.max;
  return new ParameterError(
    rejection.key,
    rejection.value,
    ranged ? `a number from ${rejection.min} to ${rejection.max}` : rejection.message,
  );
}
