/** Ranges of parameters that a driver maps its value to. */
import { ParameterError } from '../../base/errors.ts';
import type { AnyValues, Value, Values } from '../../parameters/parameter.ts';
import { valueAt, whyNotAnimated, type Lane } from '../../parameters/timeline.ts';
import { validate } from '../../parameters/values.ts';

/**
 * The values of parameters where a driver is 0 and where it is 1. Numbers and colours are between them, and so are ramps and
 * curves with equally many stops; others switch at 1. The first value may be the greater one.
 */
export type DrivenRanges = {
  readonly [Key in keyof Values]?: readonly [from: NonNullable<Values[Key]>, to: NonNullable<Values[Key]>];
};

/** Steps between both ends of a range, so that noise makes no changes and takes stay short. */
export const LEVELS = 256;

/**
 * Validates ranges, which may be any value of JavaScript.
 * @param name of the option
 * @throws ParameterError for a parameter that no timeline animates, and for invalid values
 */
export function requireRanges(name: string, given: unknown): readonly Lane[] {
  const isObject = typeof given === 'object' && given !== null && !Array.isArray(given);
  if (!isObject || Object.keys(given).length === 0)
    throw new ParameterError(name, given, "at least one range, such as { 'emission.rate': [0, 60] }");
  return Object.entries(given).map(([key, range]) => laneOf(key, range));
}

/** @param level 0 to {@link LEVELS} */
export function valuesOf(lanes: readonly Lane[], level: number): AnyValues {
  return Object.fromEntries(lanes.map((lane) => [lane.key, valueAt(lane, level)]));
}

function laneOf(key: string, range: unknown): Lane {
  const reason = whyNotAnimated(key);
  if (reason) throw new ParameterError(key, 'driven', `no driver. ${reason.replace(/\.$/, '')}`);
  if (!Array.isArray(range) || range.length !== 2)
    throw new ParameterError(key, range, 'the values at both ends, such as [0, 60]');
  const [from, to] = range as [Value, Value];
  for (const value of [from, to]) validate({ [key]: value });
  return {
    key,
    keyframes: [
      { step: 0, value: from, easing: 'linear' },
      { step: LEVELS, value: to, easing: 'linear' },
    ],
  };
}
