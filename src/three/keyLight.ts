import { Vector3, type DirectionalLight, type PointLight, type SpotLight } from 'three';
import { ParameterError } from '../base/errors.ts';
import type { Light } from '../renderer/light.ts';

/** A light of the host's scene that shades smoke. For a spot light, the position counts but not the cone. */
export type KeyLight = DirectionalLight | PointLight | SpotLight;

const KINDS = ['DirectionalLight', 'PointLight', 'SpotLight'];

/** @throws ParameterError for a type of light that cannot cast smoke's shadow */
export function requireKeyLight(light: KeyLight): void {
  if (!KINDS.includes(light?.type)) throw new ParameterError('keyLight', light?.type, `a ${KINDS.join(', a ')}`);
}

/** Position or direction of the light as three.js uses it for shading, from the world matrices of the latest frame. */
export function lightFrom(light: KeyLight): Light {
  const place = new Vector3().setFromMatrixPosition(light.matrixWorld);
  if (light.type !== 'DirectionalLight') return { kind: 'lamp', place };
  const target = new Vector3().setFromMatrixPosition((light as DirectionalLight).target.matrixWorld);
  return { kind: 'sun', towards: place.sub(target).normalize() };
}
