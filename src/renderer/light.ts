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
  /** Distance at which the light ends, in metres of the host. Default Infinity. */
  readonly end?: number;
  readonly cone?: Cone;
  /** Metres of the host for each metre of the space of the smoke. Default 1. */
  readonly scale?: number;
}

/** The cone of a spot light: the unit vector towards the lamp, and the cosines from its edge to where light is full. */
export interface Cone {
  readonly axis: Vector3;
  readonly cosines: readonly [edge: number, full: number];
}

/** Least value of distance ^ decay, as in three.js. */
export const NEAREST = 0.01;
/** Least difference between the cosines of a cone. */
const SHARPEST = 1e-5;

/** Reads the light from the flat values of a preset, which must have every key. Angles are relative to `centre`. */
export function lightOf(values: Values, centre: Vector3): Light {
  const towards = towardsLight(values['light.azimuth'] as number, values['light.elevation'] as number);
  if (values['light.kind'] !== 'lamp') return { kind: 'sun', towards };
  const place = towards.multiplyScalar(values['light.distance'] as number).add(centre);
  return { kind: 'lamp', place, falloff: { decay: values['light.decay'] as number } };
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

/**
 * Reads the direct light at a distance of 1 m, if the lamp has a decay. At the distance of the lamp from the centre of the
 * scene it is that of {@link illuminationOf}.
 */
export function lampLightOf(values: Values): Factors | undefined {
  const decay = values['light.decay']!;
  if (values['light.kind'] !== 'lamp' || decay === 0 || values['style.renderer'] !== 'nailboards') return undefined;
  const atOne = values['light.distance']! ** decay;
  return illuminationOf(values).direct.map((factor) => factor * atOne) as unknown as Factors;
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

/** A falloff as shaders/lib/falloff.glsl takes it. */
export function packedFalloff({ decay, end = Infinity, cone, scale = 1 }: Falloff): { reach: Vector4; cone: Vector4 } {
  const reach = new Vector4(decay, scale / end, NEAREST / scale ** decay, scale ** -decay);
  if (!cone) return { reach, cone: new Vector4(0, 0, 0, 1) };
  const [edge, full] = cone.cosines;
  const sharpness = 1 / Math.max(full - edge, SHARPEST);
  const { x, y, z } = cone.axis.clone().multiplyScalar(sharpness);
  return { reach, cone: new Vector4(x, y, z, -edge * sharpness) };
}
