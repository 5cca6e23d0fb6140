/** Lights besides the key light: at most three, without shadow. */
import {
  Color as ThreeColor,
  DataTexture,
  FloatType,
  RGBAFormat,
  Vector3,
  Vector4,
  type Box3,
  type IUniform,
  type Matrix4,
} from 'three';
import code from '../../shaders/additionalLights/additionalLights.glsl';
import type { FrameInput } from './frameInput.ts';
import { glowColors, glowLamps } from './glow.ts';
import type { Shaders } from './gpu/programsAhead.ts';
import { linear, type Ramp } from './gpu/ramps.ts';
import { homogeneous, type AdditionalLight, type Light } from './light.ts';
import { ShaderVariant, withCode, type AddedCode } from './gpu/shaderVariant.ts';
import { PARTS_WIDTH } from '../base/constants.ts';
import { reachOf, setReach } from './reach.ts';
import type { Style } from './style.ts';

export { glowColors };

const ADDITIONAL_LIGHTS: AddedCode = { define: 'ADDITIONAL_LIGHTS', declared: 'int lightsOn(', code };

/** Number of lights in the shaders. */
const LIGHTS = 3;
/** A light fades out while its strength falls from this many times the strength of the fourth light to the same strength. */
const FADING = 1.5;
/** Mean of max(0, N.L) over all directions. */
const MEAN_FACING = 0.25;

/** Shaders as {@link AdditionalLights} draws them. */
export function withAdditionalLights(shaders: Shaders): Shaders {
  return withCode(shaders, ADDITIONAL_LIGHTS);
}

/** Lights on one smoke and its surfaces: shaders/additionalLights/additionalLights.glsl and what it reads. */
export class AdditionalLights extends ShaderVariant {
  private readonly uniforms;
  /** Of each material, a texel, in rows of {@link PARTS_WIDTH}. */
  private readonly directParts: DataTexture;
  private style: Style | undefined;
  private colors: Float32Array | undefined;

  constructor() {
    const directParts = new DataTexture(new Float32Array(4), 1, 1, RGBAFormat, FloatType);
    const vectors = () => Array.from({ length: LIGHTS }, () => new Vector4());
    const uniforms = {
      lightCount: { value: 0 },
      lights: { value: vectors() },
      worldLights: { value: vectors() },
      lightColors: { value: Array.from({ length: LIGHTS }, () => new ThreeColor()) },
      lightReaches: { value: vectors() },
      lightCones: { value: vectors() },
      worldCones: { value: vectors() },
      lightAround: { value: new ThreeColor() },
      directParts: { value: directParts },
    } satisfies Record<string, IUniform>;
    super(ADDITIONAL_LIGHTS, uniforms);
    this.uniforms = uniforms;
    this.directParts = directParts;
  }

  /** @param ramps of all materials, in order */
  apply(ramps: readonly Ramp[]): void {
    const { directParts } = this;
    const [width, height] = [Math.min(ramps.length, PARTS_WIDTH), Math.ceil(ramps.length / PARTS_WIDTH)];
    if (directParts.image.width !== width || directParts.image.height !== height) {
      directParts.dispose();
      directParts.image = { data: new Float32Array(4 * width * height), width, height };
    }
    const data = directParts.image.data as Float32Array;
    ramps.forEach((ramp, material) => data.set(directPartOf(ramp), 4 * material));
    directParts.needsUpdate = true;
  }

  dispose(): void {
    this.directParts.dispose();
  }

  /** @param smoke world-space box of the smoke, where the strongest lights are selected */
  look(input: FrameInput, smoke: Box3, viewFromWorld: Matrix4): void {
    const { lightCount, lightAround, lightColors, lightReaches, ...both } = this.uniforms;
    const { lights, lightCones, worldLights, worldCones } = both;
    const { selected, around } = strongest([...(input.lights ?? []), ...this.glowing(input)], smoke);
    lightCount.value = selected.length;
    lightAround.value.setRGB(...around);
    selected.forEach(({ light, color }, index) => {
      const [inView, cone] = [lights.value[index], lightCones.value[index]];
      lightColors.value[index].setRGB(...color);
      inView.copy(worldLights.value[index].copy(homogeneous(light))).applyMatrix4(viewFromWorld);
      setReach(lightReaches.value[index], cone, light.kind === 'lamp' ? light.falloff : undefined);
      const { x, y, z, w } = worldCones.value[index].copy(cone);
      cone.set(x, y, z, 0).applyMatrix4(viewFromWorld).setW(w);
    });
  }

  private glowing({ simulator, style, blend }: FrameInput): readonly AdditionalLight[] {
    if (style !== this.style) this.colors = glowColors(style);
    this.style = style;
    return this.colors && simulator.glow ? glowLamps(simulator.glow(blend, this.colors)) : [];
  }
}

/** C KL of Eq. 2, linear: the difference of full light and of shadow. What glows takes less, and a source of light none. */
function directPartOf({ lit, unlit, glow = 0, glows = false }: Ramp): number[] {
  const [full, shadow] = [linear(lit[lit.length - 1].color), linear(unlit[0].color)];
  return full.map((channel, at) => (glows ? 0 : (1 - glow) * Math.max(0, channel - shadow[at])));
}

interface Selected {
  readonly selected: readonly AdditionalLight[];
  /** Linear light of the others, from all sides. */
  readonly around: [red: number, green: number, blue: number];
}

/**
 * The lights that are strongest at the smoke, in their order. What the others give, and those that are hardly stronger than
 * they are, comes from all sides: a light that takes the place of another one fades in while the other fades out.
 */
export function strongest(all: readonly AdditionalLight[], smoke: Box3): Selected {
  const reaches = all.map(({ light }) => reachOf(light, nearestIn(smoke, light)));
  const strengths = all.map(({ color }, index) => Math.max(...color) * reaches[index]);
  const [, , , most = 0] = strengths.toSorted((one, other) => other - one);
  const around: Selected['around'] = [0, 0, 0];
  const selected = all.flatMap(({ light, color }, index) => {
    const strength = strengths[index];
    const share = most > 0 ? Math.min(Math.max(0, (strength / most - 1) / (FADING - 1)), 1) : Number(strength > 0);
    const rest = MEAN_FACING * (1 - share) * reaches[index];
    color.forEach((factor, at) => (around[at] += rest * factor));
    const [red, green, blue] = color.map((factor) => share * factor);
    return share > 0 ? [{ light, color: [red, green, blue] as const }] : [];
  });
  return { selected, around };
}

/** Where the light of a lamp is strong: the nearest place of the smoke, but not close to the lamp. */
function nearestIn(smoke: Box3, light: Light): Vector3 {
  if (light.kind === 'sun') return new Vector3();
  const place = smoke.clampPoint(light.place, new Vector3());
  const least = smoke.getSize(new Vector3()).length() / 4;
  if (place.distanceTo(light.place) >= least) return place;
  const inwards = smoke.getCenter(new Vector3()).sub(light.place);
  if (inwards.lengthSq() === 0) inwards.y = 1;
  return inwards.setLength(least).add(light.place);
}
