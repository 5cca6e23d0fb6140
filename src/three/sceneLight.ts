import {
  Color,
  type AmbientLight,
  type Camera,
  type HemisphereLight,
  type Object3D,
  type Scene,
  type Vector3,
} from 'three';
import { ParameterError } from '../base/errors.ts';
import type { Factors } from '../renderer/gpu/ramps.ts';
import type { Style } from '../renderer/style.ts';
import { hasFalloff, reachOf, type KeyLight } from './keyLight.ts';

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
   * @param place of the smoke in the world: its ink has the light of a lamp there. Puffs have that at their own place
   */
  styleOf(style: Style, scene: Scene, camera: Camera, keyLight: KeyLight, place: Vector3): Style {
    const { key, ambient } = this.reference;
    const isLit = isUsed(keyLight, scene, camera) && keyLight.intensity > 0;
    const near = isLit ? over(keyLight.color, keyLight.intensity / key) : DARK;
    const lampLight = hasFalloff(keyLight) ? times(style.illumination.direct, near) : undefined;
    const reach = reachOf(keyLight, place);
    const there: Factors = [reach * near[0], reach * near[1], reach * near[2]];
    const illumination = {
      direct: times(style.illumination.direct, there),
      ambient: times(style.illumination.ambient, over(ambientIn(scene, camera), 1 / ambient)),
    };
    const lit = { illumination, lampLight };
    if (style !== this.base || !this.lit || !areEqual(this.lit, lit)) {
      this.lit = { ...style, ...lit, shadows: style.shadows && near.some((factor) => factor > 0) };
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

function over({ r, g, b }: Color, factor: number): Factors {
  return [factor * r, factor * g, factor * b];
}

function times(one: Factors, other: Factors): Factors {
  return [one[0] * other[0], one[1] * other[1], one[2] * other[2]];
}

type Lit = Pick<Style, 'illumination' | 'lampLight'>;

function areEqual(one: Lit, other: Lit): boolean {
  const [own, others] = [one, other].map(({ illumination: { direct, ambient }, lampLight = [] }) => [
    ...direct,
    ...ambient,
    ...lampLight,
  ]);
  return own.length === others.length && own.every((factor, at) => factor === others[at]);
}
