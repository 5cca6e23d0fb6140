import { MathUtils, Vector3, Vector4 } from 'three';
import type { Values } from '../parameters/parameter.ts';
import { linear, type Factors, type Illumination } from './gpu/ramps.ts';
import { parseColor } from './palette.ts';

/** Least elevation of a moving light, degrees. */
const LOWEST = 5;

/** The light: a sun with parallel rays, or a lamp at a position. World space, metres. */
export type Light =
  | { readonly kind: 'sun'; /** Unit vector. */ readonly towards: Vector3 }
  | { readonly kind: 'lamp'; readonly place: Vector3; readonly falloff?: Falloff };

/** How the light of a lamp weakens with distance, as that of a PointLight or a SpotLight of three.js. */
export interface Falloff {
  readonly decay: number;
  /** Distance at which the light ends, in its units. Default Infinity. */
  readonly end?: number;
  /** Least value of distance ^ decay. Default 0.01, as in three.js. */
  readonly least?: number;
  readonly cone?: Cone;
  /** Units of distance for each metre of the space of the smoke. Default 1. */
  readonly scale?: number;
}

/** The cone of a spot light: the unit vector towards the lamp, and the cosines from its edge to where light is full. */
export interface Cone {
  readonly axis: Vector3;
  readonly cosines: readonly [edge: number, full: number];
}

/** A light besides the key light. It casts no shadow. */
export interface AdditionalLight {
  readonly light: Light;
  /** Factors on the direct light of the style. */
  readonly color: Factors;
}

/** Reads the light from the flat values of a preset, which must have every key. Angles are relative to `centre`. */
export function lightOf(values: Values, centre: Vector3): Light {
  const towards = towardsLight(values['light.azimuth'] as number, values['light.elevation'] as number);
  if (values['light.kind'] !== 'lamp') return { kind: 'sun', towards };
  const distance = values['light.distance'] as number;
  const falloff = { decay: values['light.decay'] as number, scale: 1 / distance };
  return { kind: 'lamp', place: towards.multiplyScalar(distance).add(centre), falloff };
}

/**
 * Reads the colours and strengths of the light from flat values, which must have their keys. A host multiplies them by those
 * of its own lights.
 */
export function illuminationOf(values: Values): Illumination {
  const factors = (color: string, strength: number) =>
    linear(parseColor(color)).map((light) => light * strength) as unknown as Factors;
  return {
    direct: factors(values['light.color']!, values['light.intensity']!),
    ambient: factors(values['light.ambientColor']!, values['light.ambient']!),
  };
}

/** Whether the light is a lamp whose light weakens with distance. Other renderers than nailboards do not show it. */
export function hasDecay(values: Values): boolean {
  return values['light.kind'] === 'lamp' && values['light.decay']! > 0 && values['style.renderer'] === 'nailboards';
}

/**
 * Returns a copy of the values with the light moved by angles in degrees. The elevation has a lower limit, because the
 * shadows of a light at the horizon are infinite.
 */
export function moved(values: Values, { azimuth, elevation }: { azimuth: number; elevation: number }): Values {
  const height = (values['light.elevation'] as number) + elevation;
  return {
    ...values,
    'light.azimuth': (values['light.azimuth'] as number) + azimuth,
    'light.elevation': MathUtils.clamp(height, LOWEST, 90),
  };
}

/**
 * The unit vector towards the light, world space.
 * @param azimuth degrees about the vertical; 0 is from the front (+z), positive turns to the right (+x)
 * @param elevation degrees above the horizon
 */
export function towardsLight(azimuth: number, elevation: number): Vector3 {
  return new Vector3().setFromSphericalCoords(1, MathUtils.degToRad(90 - elevation), MathUtils.degToRad(azimuth));
}

/** The light as the shaders take it: (unit vector towards the light, 0) or (position of the light, 1). */
export function homogeneous(light: Light): Vector4 {
  return light.kind === 'sun'
    ? new Vector4(light.towards.x, light.towards.y, light.towards.z, 0)
    : new Vector4(light.place.x, light.place.y, light.place.z, 1);
}
