import type { NumberParameter } from '../../preset/parameter.ts';

/** A slider has this many places on each side of its origin; enough for every pixel of a wide panel. */
export const PLACES = 500;

/** Where the fine part of a range lies: zero when the range holds it, else its lower end. */
function origin({ min, max }: NumberParameter): number {
  return min < 0 && max > 0 ? 0 : min;
}

/** The lowest place of a slider: -PLACES when its range goes below its origin, else 0. */
export function lowestPlace(parameter: NumberParameter): number {
  return parameter.min < origin(parameter) ? -PLACES : 0;
}

/** The place of a value on its slider. */
export function placeOf(parameter: NumberParameter, value: number): number {
  const share = (value - origin(parameter)) / spanTowards(parameter, value >= origin(parameter));
  return Math.round(PLACES * (parameter.slider === 'fine' ? Math.cbrt(share) : share));
}

/** The value at a place of the slider, on a whole number of steps from the origin, within the range. */
export function valueAt(parameter: NumberParameter, place: number): number {
  // The ends need not lie on a step.
  if (place >= PLACES) return parameter.max;
  if (place <= -PLACES) return parameter.min;
  const share = place / PLACES;
  const bent = parameter.slider === 'fine' ? share ** 3 : share;
  const value = origin(parameter) + bent * spanTowards(parameter, place >= 0);
  return clampToStep(parameter, value);
}

/** The value one press of an arrow key away; a cubed slider would else move by nothing near its origin. */
export function stepBy(parameter: NumberParameter, value: number, steps: number): number {
  return clampToStep(parameter, value + steps * parameter.step);
}

function spanTowards(parameter: NumberParameter, upwards: boolean): number {
  return upwards ? parameter.max - origin(parameter) : origin(parameter) - parameter.min;
}

function clampToStep(parameter: NumberParameter, value: number): number {
  const { min, max, step } = parameter;
  const steps = Math.round((value - origin(parameter)) / step);
  // Through a decimal text, so that 3 steps of 0.1 are 0.3 in the link and not 0.30000000000000004.
  const rounded = Number((origin(parameter) + steps * step).toPrecision(10));
  return Math.min(Math.max(rounded, min), max);
}
