import type { NumberParameter } from '../../preset.ts';

/** Slider positions on each side of the origin: enough for every pixel of a wide panel. */
export const PLACES = 500;

/** Origin of the fine part of a range: 0 if the range contains it, otherwise the lower end. */
function origin({ min, max }: NumberParameter): number {
  return min < 0 && max > 0 ? 0 : min;
}

/** Lowest slider position: -PLACES when the range extends below its origin, otherwise 0. */
export function lowestPlace(parameter: NumberParameter): number {
  return parameter.min < origin(parameter) ? -PLACES : 0;
}

/** The slider position of a value. */
export function placeOf(parameter: NumberParameter, value: number): number {
  const share = (value - origin(parameter)) / spanTowards(parameter, value >= origin(parameter));
  return Math.round(PLACES * (parameter.slider === 'fine' ? Math.cbrt(share) : share));
}

/** The value at a slider position, rounded to a multiple of the step from the origin, within the range. */
export function valueAt(parameter: NumberParameter, place: number): number {
  // The ends of the range may not be multiples of the step.
  if (place >= PLACES) return parameter.max;
  if (place <= -PLACES) return parameter.min;
  const share = place / PLACES;
  const bent = parameter.slider === 'fine' ? share ** 3 : share;
  const value = origin(parameter) + bent * spanTowards(parameter, place >= 0);
  return clampToStep(parameter, value);
}

/** The value after arrow-key presses. On a cubic slider, a step in position would be too small near the origin. */
export function stepBy(parameter: NumberParameter, value: number, steps: number): number {
  return clampToStep(parameter, value + steps * parameter.step);
}

function spanTowards(parameter: NumberParameter, upwards: boolean): number {
  return upwards ? parameter.max - origin(parameter) : origin(parameter) - parameter.min;
}

function clampToStep(parameter: NumberParameter, value: number): number {
  const { min, max, step } = parameter;
  const steps = Math.round((value - origin(parameter)) / step);
  // Rounds through a decimal string: 3 steps of 0.1 give 0.3 in the link, not 0.30000000000000004.
  const rounded = Number((origin(parameter) + steps * step).toPrecision(10));
  return Math.min(Math.max(rounded, min), max);
}
