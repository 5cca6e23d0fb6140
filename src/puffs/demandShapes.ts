import { ShapeError } from '../preset/errors.ts';
import { MAX_LOBES, reachOf } from './lobes.ts';
import type { PuffShape } from './shapes.ts';

/** The most variations that smoke can have. */
export const MAX_VARIATIONS = 32;
/** Lobes that were fitted into the unit ball may stand out of it by what rounding adds. */
const LARGEST_REACH = 1.001;

/** @throws ShapeError for shapes that somebody made otherwise than puffs have to be, naming what would be accepted */
export function demandShapes(shapes: readonly PuffShape[]): void {
  if (shapes.length < 1 || shapes.length > MAX_VARIATIONS) {
    throw new ShapeError(`Smoke cannot have ${shapes.length} puff shapes: it takes 1 to ${MAX_VARIATIONS}.`);
  }
  for (const { name, lobes } of shapes) {
    if (lobes.length < 1 || lobes.length > MAX_LOBES) {
      throw new ShapeError(`The puff ${name} has ${lobes.length} lobes: it takes 1 to ${MAX_LOBES}.`);
    }
    if (!lobes.every(({ radius }) => radius > 0) || !(reachOf(lobes) <= LARGEST_REACH)) {
      throw new ShapeError(`The puff ${name} must lie within the unit ball, and its lobes have radii above 0.`);
    }
  }
}
