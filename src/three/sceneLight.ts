import {
  Color,
  type AmbientLight,
  type Camera,
  type HemisphereLight,
  type Object3D,
  type PointLight,
  type Scene,
  type Vector3,
} from 'three';
import { ParameterError } from '../base/errors.ts';
import type { Factors } from '../renderer/gpu/ramps.ts';
import { IRRADIANCE } from '../renderer/glow.ts';
import { showsAdditionalLights, type Style } from '../renderer/style.ts';
import type { AdditionalLight } from '../renderer/light.ts';
import { reachOf } from '../renderer/reach.ts';
import { isKeyLight, lightFrom, hasFalloff, type KeyLight } from './keyLight.ts';

/** What lights smoke in a frame. */
interface LitScene {
  readonly scene: Scene;
  readonly camera: Camera;
  readonly keyLight: KeyLight;
  /** Lights of the smoke itself. */
  readonly own: readonly PointLight[];
}

/** Smoke in the light of a scene. */
export interface LitSmoke {
  readonly style: Style;
  /** Lights besides the key light, in the space of the world. */
  readonly lights: readonly AdditionalLight[];
}

/** The lights under which smoke has the colours of its style. */
export interface LightReference {
  /** Irradiance of a surface that faces the key light: for a directional light, its intensity. Default 3. */
  readonly key: number;
  /** Intensity of all ambient lights together. Default 1. */
  readonly ambient: number;
}

const REFERENCE: LightReference = { key: IRRADIANCE, ambient: 1 };
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
   * The style under the lights that three.js uses for a camera, and those besides the key light. Without direct light smoke
   * casts no shadow.
   * @param place of the smoke in the world: its ink has the light of a lamp there. Puffs have that at their own place
   */
  under(style: Style, { scene, camera, keyLight, own }: LitScene, place: Vector3): LitSmoke {
    const { key, ambient } = this.reference;
    const found = lightsIn(scene, camera);
    const others = showsAdditionalLights(style)
      ? found.others.filter((light) => light !== keyLight && light.intensity > 0 && !own.includes(light as PointLight))
      : [];
    const isLit = isUsed(keyLight, scene, camera) && keyLight.intensity > 0;
    const near = isLit ? over(keyLight.color, keyLight.intensity / key) : DARK;
    const lampLight = hasFalloff(keyLight) ? times(style.illumination.direct, near) : undefined;
    const reach = reachOf(lightFrom(keyLight), place);
    const there: Factors = [reach * near[0], reach * near[1], reach * near[2]];
    const illumination = {
      direct: times(style.illumination.direct, there),
      ambient: times(style.illumination.ambient, over(found.ambient, 1 / ambient)),
    };
    const hasAdditionalLights = style.hasAdditionalLights || others.length > 0;
    const lit = { illumination, lampLight, hasAdditionalLights };
    if (style !== this.base || !this.lit || !areEqual(this.lit, lit)) {
      this.lit = { ...style, ...lit, shadows: style.shadows && near.some((factor) => factor > 0) };
      this.base = style;
    }
    const lights = others.map((light) => ({
      light: lightFrom(light),
      color: times(style.illumination.direct, over(light.color, light.intensity / key)),
    }));
    return { style: this.lit, lights };
  }
}

/** Whether three.js lights the objects of a scene with a light. */
function isUsed(light: Object3D, scene: Scene, camera: Camera): boolean {
  if (!light.layers.test(camera.layers)) return false;
  for (let each: Object3D | null = light; each?.visible; each = each.parent) if (each === scene) return true;
  return false;
}

/**
 * The lights of a scene that three.js uses for a camera: the sum of all ambient light, in linear light, and those with a
 * direction. Of hemisphere lights, the mean of both colours is ambient.
 */
function lightsIn(scene: Scene, camera: Camera): { ambient: Color; others: KeyLight[] } {
  const ambient = new Color(0, 0, 0);
  const others: KeyLight[] = [];
  const add = (color: Color, strength: number) => {
    ambient.r += strength * color.r;
    ambient.g += strength * color.g;
    ambient.b += strength * color.b;
  };
  scene.traverseVisible((object) => {
    if (!object.layers.test(camera.layers)) return;
    const { isAmbientLight, color, intensity } = object as AmbientLight;
    const { isHemisphereLight, groundColor } = object as HemisphereLight;
    if (isAmbientLight) add(color, intensity);
    else if (isHemisphereLight) for (const half of [color, groundColor]) add(half, intensity / 2);
    else if (isKeyLight(object)) others.push(object);
  });
  return { ambient, others };
}

function over({ r, g, b }: Color, factor: number): Factors {
  return [factor * r, factor * g, factor * b];
}

function times(one: Factors, other: Factors): Factors {
  return [one[0] * other[0], one[1] * other[1], one[2] * other[2]];
}

type Lit = Pick<Style, 'illumination' | 'lampLight' | 'hasAdditionalLights'>;

function areEqual(one: Lit, other: Lit): boolean {
  const [own, others] = [one, other].map(({ illumination: { direct, ambient }, lampLight = [], ...rest }) => [
    ...direct,
    ...ambient,
    ...lampLight,
    Number(rest.hasAdditionalLights),
  ]);
  return own.length === others.length && own.every((factor, at) => factor === others[at]);
}
