import { Vector3, type DirectionalLight, type Object3D, type PointLight, type SpotLight } from 'three';
import { ParameterError } from '../base/errors.ts';
import type { Cone, Falloff, Light } from '../renderer/light.ts';

/** A light of the host's scene that shades smoke. */
export type KeyLight = DirectionalLight | PointLight | SpotLight;

const KINDS = ['DirectionalLight', 'PointLight', 'SpotLight'];

/** Whether an object is a light with a direction. */
export function isKeyLight(object: Object3D): object is KeyLight {
  return KINDS.includes(object?.type);
}

/** @throws ParameterError for a type of light that cannot cast smoke's shadow */
export function requireKeyLight(light: KeyLight): void {
  if (!isKeyLight(light))
    throw new ParameterError('keyLight', (light as Object3D | undefined)?.type, `a ${KINDS.join(', a ')}`);
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

function placeOf({ matrixWorld }: KeyLight): Vector3 {
  return new Vector3().setFromMatrixPosition(matrixWorld);
}

/** Unit vector from the target of a light to the light. */
function axisOf(light: DirectionalLight | SpotLight): Vector3 {
  return placeOf(light).sub(new Vector3().setFromMatrixPosition(light.target.matrixWorld)).normalize();
}
