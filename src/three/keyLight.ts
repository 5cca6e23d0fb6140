import { MathUtils, Vector3, type DirectionalLight, type PointLight, type SpotLight } from 'three';
import { ParameterError } from '../base/errors.ts';
import type { Cone, Falloff } from '../renderer/gpu/frameView.ts';
import { NEAREST, type Light } from '../renderer/light.ts';

/** A light of the host's scene that shades smoke. */
export type KeyLight = DirectionalLight | PointLight | SpotLight;

const KINDS = ['DirectionalLight', 'PointLight', 'SpotLight'];

/** @throws ParameterError for a type of light that cannot cast smoke's shadow */
export function requireKeyLight(light: KeyLight): void {
  if (!KINDS.includes(light?.type)) throw new ParameterError('keyLight', light?.type, `a ${KINDS.join(', a ')}`);
}

/** Position or direction of the light as three.js uses it for shading, from the world matrices of the latest frame. */
export function lightFrom(light: KeyLight): Light {
  const place = placeOf(light);
  if (light.type !== 'DirectionalLight') return { kind: 'lamp', place, falloff: falloffOf(light as PointLight) };
  return { kind: 'sun', towards: axisOf(light as DirectionalLight) };
}

/** Whether the light of a key light differs from place to place. */
export function hasFalloff(light: KeyLight): boolean {
  if (light.type === 'DirectionalLight') return false;
  const { decay, end, cone } = falloffOf(light as PointLight);
  return decay > 0 || end < Infinity || cone !== undefined;
}

function falloffOf(light: PointLight | SpotLight): Falloff & { end: number } {
  const { decay, distance } = light;
  return { decay, end: distance > 0 ? distance : Infinity, cone: coneOf(light) };
}

function coneOf(light: PointLight | SpotLight): Cone | undefined {
  if (light.type !== 'SpotLight') return undefined;
  const { angle, penumbra } = light as SpotLight;
  return { axis: axisOf(light as SpotLight), cosines: [Math.cos(angle), Math.cos(angle * (1 - penumbra))] };
}

/** Share of the intensity of a light that reaches a place, as `punctualLightIntensity` of three.js computes it. */
export function reachOf(light: KeyLight, place: Vector3): number {
  if (light.type === 'DirectionalLight') return 1;
  const { decay, end, cone } = falloffOf(light as PointLight);
  const towards = placeOf(light).sub(place);
  const metres = towards.length();
  const atEnd = MathUtils.clamp(1 - (metres / end) ** 4, 0, 1) ** 2;
  const inCone = cone ? MathUtils.smoothstep(cone.axis.dot(towards.normalize()), ...cone.cosines) : 1;
  return (atEnd / Math.max(metres ** decay, NEAREST)) * inCone;
}

function placeOf({ matrixWorld }: KeyLight): Vector3 {
  return new Vector3().setFromMatrixPosition(matrixWorld);
}

/** Unit vector from the target of a light to the light. */
function axisOf(light: DirectionalLight | SpotLight): Vector3 {
  return placeOf(light).sub(new Vector3().setFromMatrixPosition(light.target.matrixWorld)).normalize();
}
