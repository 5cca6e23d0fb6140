/** How much of the light of a lamp reaches a place, for the few lights that weaken with distance. */
import { MathUtils, type Vector3, type Vector4 } from 'three';
import type { Falloff, Light } from './light.ts';

/** Least value of distance ^ decay, as in three.js. */
export const NEAREST = 0.01;

/** Share of a light that reaches a place, as `punctualLightIntensity` of three.js computes it. */
export function reachOf(light: Light, place: Vector3): number {
  if (light.kind === 'sun' || !light.falloff) return 1;
  const { decay, end = Infinity, least = NEAREST, cone, scale = 1 } = light.falloff;
  const towards = light.place.clone().sub(place);
  const distance = scale * towards.length();
  const atEnd = MathUtils.clamp(1 - (distance / end) ** 4, 0, 1) ** 2;
  const inCone = cone ? MathUtils.smoothstep(cone.axis.dot(towards.normalize()), ...cone.cosines) : 1;
  return (atEnd / Math.max(distance ** decay, least)) * inCone;
}

/** Least difference between the cosines of a cone. */
const SHARPEST = 1e-5;

/** Sets the last two arguments of `reachOf` in shaders/falloff/reach.glsl. */
export function setReach(reach: Vector4, cone: Vector4, falloff: Falloff = { decay: 0 }): void {
  const { decay, end = Infinity, least = NEAREST, scale = 1 } = falloff;
  reach.set(decay, scale / end, least / scale ** decay, scale ** -decay);
  cone.set(0, 0, 0, 1);
  if (!falloff.cone) return;
  const [edge, full] = falloff.cone.cosines;
  const sharpness = 1 / Math.max(full - edge, SHARPEST);
  const { x, y, z } = falloff.cone.axis;
  cone.set(x, y, z, -edge).multiplyScalar(sharpness);
}
