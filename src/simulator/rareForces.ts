/**
 * Forces that few smokes have. Their code is in the larger variants of the simulator only. All variants have their parameters,
 * but a core simulator waits with its next step until it has moved to a larger one, so that the smoke is the same.
 */
import type { AnyValues } from '../parameters/parameter.ts';

/** The lists of rare forces. */
const KEY = /\b(flows|shapes)\.\d/;

/** Whether values have rare forces, or their timeline has. */
export function hasRareForces(values: AnyValues): boolean {
  return KEY.test([...Object.keys(values), values.timeline].join());
}
