/** What both engines need to know of the six forces in their own terms. */
import { SIX_FORCES } from './cloud.ts';

/** Seconds. */
export const STEP = 1 / 60;

/** Metres: about the mean distance of the seeded cloud from the vortex's axis. */
export const TYPICAL_DISTANCE = 3.8;

/** Radians a second at which the vortex turns what is so many metres from its axis, outside of its core. */
export function angularRate(distance: number): number {
  return SIX_FORCES['vortices.0.circulation'] / (2 * Math.PI * distance ** 2);
}
