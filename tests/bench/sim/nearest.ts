/** Derived values of the six forces that both engines need. */
import { SIX_FORCES } from './cloud.ts';

/** Seconds. */
export const STEP = 1 / 60;

/** Metres: approximate mean distance of the seeded cloud from the vortex axis. */
export const TYPICAL_DISTANCE = 3.8;

/** Angular rate of the vortex at a distance from its axis outside the core, rad/s. */
export function angularRate(distance: number): number {
  return SIX_FORCES['vortices.0.circulation'] / (2 * Math.PI * distance ** 2);
}
