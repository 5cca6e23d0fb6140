import { MathUtils, Vector3 } from 'three';

/**
 * The unit vector towards a directional light, in world space.
 * @param azimuth degrees about the vertical; 0 is from the front (+z), positive turns to the right (+x)
 * @param elevation degrees above the horizon
 */
export function towardsLight(azimuth: number, elevation: number, into = new Vector3()): Vector3 {
  return into.setFromSphericalCoords(1, MathUtils.degToRad(90 - elevation), MathUtils.degToRad(azimuth));
}
