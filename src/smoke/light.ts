import { MathUtils, Vector3, Vector4 } from 'three';

/** What lights the smoke: a sun, whose rays are parallel, or a lamp at a place. World space, metres. */
export type Light =
  | { readonly kind: 'sun'; /** Unit vector. */ readonly towards: Vector3 }
  | { readonly kind: 'lamp'; readonly place: Vector3 };

/** How a person sets a light, seen from the centre of a scene. */
export interface LightSetting {
  kind: Light['kind'];
  /** Degrees about the vertical; 0 is from the front (+z), positive turns to the right (+x). */
  azimuth: number;
  /** Degrees above the horizon. */
  elevation: number;
  /** From the centre to a lamp, metres; a sun has none. */
  distance: number;
}

/** The light that stands so, seen from the centre. */
export function lightOf({ kind, azimuth, elevation, distance }: LightSetting, centre: Vector3): Light {
  const towards = towardsLight(azimuth, elevation);
  return kind === 'sun' ? { kind, towards } : { kind, place: towards.multiplyScalar(distance).add(centre) };
}

/** Unit vector in world space; the angles are those of {@link LightSetting}. */
export function towardsLight(azimuth: number, elevation: number): Vector3 {
  return new Vector3().setFromSphericalCoords(1, MathUtils.degToRad(90 - elevation), MathUtils.degToRad(azimuth));
}

/** A light as the shaders take it: (unit vector towards it, 0) or (its place, 1). */
export function homogeneous(light: Light): Vector4 {
  return light.kind === 'sun'
    ? new Vector4(light.towards.x, light.towards.y, light.towards.z, 0)
    : new Vector4(light.place.x, light.place.y, light.place.z, 1);
}
