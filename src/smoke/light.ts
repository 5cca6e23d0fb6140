import { MathUtils, Vector3, Vector4 } from 'three';
import type { Values } from '../preset/parameter.ts';

/** Of a light that moves by itself, degrees. */
const LOWEST = 5;

/** What lights the smoke: a sun, whose rays are parallel, or a lamp at a place. World space, metres. */
export type Light =
  | { readonly kind: 'sun'; /** Unit vector. */ readonly towards: Vector3 }
  | { readonly kind: 'lamp'; readonly place: Vector3 };

/** Reads the light out of flat values that hold every key of the table; `centre` is what its angles are seen from. */
export function lightOf(values: Values, centre: Vector3): Light {
  const towards = towardsLight(values['light.azimuth'] as number, values['light.elevation'] as number);
  if (values['light.kind'] !== 'lamp') return { kind: 'sun', towards };
  return { kind: 'lamp', place: towards.multiplyScalar(values['light.distance'] as number).add(centre) };
}

/** The same values with the light elsewhere; it never sinks to where shadows would have no end. Degrees. */
export function moved(values: Values, { azimuth, elevation }: { azimuth: number; elevation: number }): Values {
  const height = (values['light.elevation'] as number) + elevation;
  return {
    ...values,
    'light.azimuth': (values['light.azimuth'] as number) + azimuth,
    'light.elevation': MathUtils.clamp(height, LOWEST, 90),
  };
}

/**
 * Unit vector in world space.
 * @param azimuth degrees about the vertical; 0 is from the front (+z), positive turns to the right (+x)
 * @param elevation degrees above the horizon
 */
export function towardsLight(azimuth: number, elevation: number): Vector3 {
  return new Vector3().setFromSphericalCoords(1, MathUtils.degToRad(90 - elevation), MathUtils.degToRad(azimuth));
}

/** A light as the shaders take it: (unit vector towards it, 0) or (its place, 1). */
export function homogeneous(light: Light): Vector4 {
  return light.kind === 'sun'
    ? new Vector4(light.towards.x, light.towards.y, light.towards.z, 0)
    : new Vector4(light.place.x, light.place.y, light.place.z, 1);
}
