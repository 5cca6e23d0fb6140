/** What the simulator does not take, and why. */
import { ParameterError, SimulatorError } from '../preset/errors.ts';

/** As the Rust side makes it. */
export interface SimulatorRejection {
  /** Of the parameter; empty where it is about none. */
  readonly key: string;
  readonly value: number;
  /** What is taken, where `min` is no greater than `max`; else `message` says it. */
  readonly min: number;
  readonly max: number;
  readonly message: string;
}

/** Whether it was thrown because a call was refused, and not by a fault. */
export function isSimulatorRejection(error: unknown): error is SimulatorRejection {
  return typeof error === 'object' && error !== null && 'key' in error && 'message' in error;
}

/** The error that callers get of it. */
export function errorOfSimulator(rejection: SimulatorRejection): Error {
  if (rejection.key === '') return new SimulatorError(rejection.message);
  const ranged = rejection.min <= rejection.max;
  return new ParameterError(
    rejection.key,
    rejection.value,
    ranged ? `a number from ${rejection.min} to ${rejection.max}` : rejection.message,
  );
}
