import {
  Color,
  MathUtils,
  Vector3,
  type AmbientLight,
  type Camera,
  type HemisphereLight,
  type Object3D,
  type PointLight,
  type Scene,
  type SpotLight,
} from 'three';
import { ParameterError } from '../base/errors.ts';
import type { Factors, Illumination } from '../renderer/gpu/ramps.ts';
import type { Style } from '../renderer/style.ts';
import type { KeyLight } from './keyLight.ts';

/** The lights under which smoke has the colours of its style. */
export interface LightReference {
  /** Irradiance of a surface that faces the key light: for a directional light, its intensity. Default 3. */
  readonly key: number;
  /** Intensity of all ambient lights together. Default 1. */
  readonly ambient: number;
}

const REFERENCE: LightReference = { key: 3, ambient: 1 };
const DARK: Factors = [0, 0, 0];

/** @throws ParameterError for a number that is not positive */
export function requireLightReference(given: Partial<LightReference>): void {
  for (const [name, value] of Object.entries(given)) {
    const isKnown = name in REFERENCE && Number.isFinite(value) && value > 0;
    if (!isKnown) throw new ParameterError(`lightReference.${name}`, value, 'key and ambient, numbers above 0');
  }
}

/** The lights of a host's scene as factors on those of the style: a and k of Eq. 2, see `Illumination`. */
export class SceneLight {
  private readonly reference: LightReference;
  private base: Style | undefined;
  private lit: Style | undefined;

  constructor(reference: Partial<LightReference> = {}) {
    this.reference = { ...REFERENCE, ...reference };
  }

  /**
   * The style under the lights that three.js uses for a camera. Without direct light smoke casts no shadow.
   * @param place of the smoke in the world, for key lights that are not directional
   */
  styleOf(style: Style, scene: Scene, camera: Camera, keyLight: KeyLight, place: Vector3): Style {
    const { key, ambient } = this.reference;
    const isLit = isUsed(keyLight, scene, camera) && keyLight.intensity > 0;
    const direct = isLit ? over(keyLight.color, (keyLight.intensity * reachOf(keyLight, place)) / key) : DARK;
    const illumination = product(style.illumination, { direct, ambient: over(ambientIn(scene, camera), 1 / ambient) });
    if (style !== this.base || !this.lit || !areEqual(this.lit.illumination, illumination)) {
      this.lit = { ...style, illumination, shadows: style.shadows && direct.some((factor) => factor > 0) };
      this.base = style;
    }
    return this.lit;
  }
}

/** Whether three.js lights the objects of a scene with a light. */
function isUsed(light: Object3D, scene: Scene, camera: Camera): boolean {
  if (!light.layers.test(camera.layers)) return false;
  for (let each: Object3D | null = light; each?.visible; each = each.parent) if (each === scene) return true;
  return false;
}

/** The ambient light of a scene, in linear light. Of hemisphere lights, the mean of both colours. */
function ambientIn(scene: Scene, camera: Camera): Color {
  const sum = new Color(0, 0, 0);
  const add = (color: Color, strength: number) => {
    sum.r += strength * color.r;
    sum.g += strength * color.g;
    sum.b += strength * color.b;
  };
  scene.traverseVisible((object) => {
    if (!object.layers.test(camera.layers)) return;
    const { isAmbientLight, color, intensity } = object as AmbientLight;
    const { isHemisphereLight, groundColor } = object as HemisphereLight;
    if (isAmbientLight) add(color, intensity);
    if (!isHemisphereLight) return;
    for (const half of [color, groundColor]) add(half, intensity / 2);
  });
  return sum;
}

/** Share of the intensity of a light that reaches a place, as `punctualLightIntensity` of three.js computes it. */
function reachOf(light: KeyLight, place: Vector3): number {
  if (light.type === 'DirectionalLight') return 1;
  const { decay, distance } = light as PointLight;
  const towards = new Vector3().setFromMatrixPosition(light.matrixWorld).sub(place);
  const metres = towards.length();
  const end = distance > 0 ? MathUtils.clamp(1 - (metres / distance) ** 4, 0, 1) ** 2 : 1;
  return (end / Math.max(metres ** decay, 0.01)) * inCone(light, towards.normalize());
}

function inCone(light: KeyLight, towards: Vector3): number {
  if (light.type !== 'SpotLight') return 1;
  const { angle, penumbra, target, matrixWorld } = light as SpotLight;
  const axis = new Vector3().setFromMatrixPosition(matrixWorld);
  axis.sub(new Vector3().setFromMatrixPosition(target.matrixWorld)).normalize();
  return MathUtils.smoothstep(axis.dot(towards), Math.cos(angle), Math.cos(angle * (1 - penumbra)));
}

function over({ r, g, b }: Color, factor: number): Factors {
  return [factor * r, factor * g, factor * b];
}

function product(one: Illumination, other: Illumination): Illumination {
  const times = (a: Factors, b: Factors): Factors => [a[0] * b[0], a[1] * b[1], a[2] * b[2]];
  return { direct: times(one.direct, other.direct), ambient: times(one.ambient, other.ambient) };
}

function areEqual(one: Illumination, other: Illumination): boolean {
  const same = (a: Factors, b: Factors) => a.every((factor, at) => factor === b[at]);
  return same(one.direct, other.direct) && same(one.ambient, other.ambient);
}
