import { Vector3, type DirectionalLight, type PointLight, type SpotLight } from 'three';
import { ParameterError } from '../preset/errors.ts';
import type { Light } from '../smoke/light.ts';

/** A light of the host's scene that smoke is shaded by; of a spot light its place counts, not its cone. */
export type KeyLight = DirectionalLight | PointLight | SpotLight;

const KINDS = ['DirectionalLight', 'PointLight', 'SpotLight'];

/** @throws ParameterError for a light whose shadow smoke cannot throw */
export function requireKeyLight(light: KeyLight): void {
  if (!KINDS.includes(light?.type)) throw new ParameterError('keyLight', light?.type, `a ${KINDS.join(', a ')}`);
}

/** Where the light is as three.js itself shades by it: by the world matrices of its latest frame. */
export function lightFrom(light: KeyLight): Light {
  const place = new Vector3().setFromMatrixPosition(light.matrixWorld);
  if (light.type !== 'DirectionalLight') return { kind: 'lamp', place };
  const target = new Vector3().setFromMatrixPosition((light as DirectionalLight).target.matrixWorld);
  return { kind: 'sun', towards: place.sub(target).normalize() };
}
