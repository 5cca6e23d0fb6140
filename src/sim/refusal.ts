/** What the simulator does not take, and why. */
import { ParameterError, SimulatorError } from '../preset/errors.ts';

/** As the Rust side makes it. */
export interface Refusal {
  /** Of the parameter; empty where it is about none. */
  readonly key: string;
  readonly value: number;
  /** What is taken, where `min` is no greater than `max`; else `message` says it. */
  readonly min: number;
  readonly max: number;
  readonly message: string;
}

/** Whether it was thrown because a call was refused, and not by a fault. */
export function isRefusal(error: unknown): error is Refusal {
  return typeof error === 'object' && error !== null && 'key' in error && 'message' in error;
}

/** The error that callers get of it. */
export function explainRefusal(refusal: Refusal): Error {
  if (refusal.key === '') return new SimulatorError(refusal.message);
  const ranged = refusal.min <= refusal.max;
  return new ParameterError(
    refusal.key,
    refusal.value,
    ranged ? `a number from ${refusal.min} to ${refusal.max}` : refusal.message,
  );
}
