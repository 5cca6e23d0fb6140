/** The light of lamps that weakens with distance, which few smokes have. */
import { Color as ThreeColor, SRGBColorSpace, Vector3, Vector4, type IUniform } from 'three';
import code from '../../shaders/falloff/falloff.glsl';
import type { Shaders } from './gpu/programsAhead.ts';
import { linear, RampTexture, type Ramp } from './gpu/ramps.ts';
import type { Falloff } from './light.ts';
import { ShaderVariant, withCode, type AddedCode } from './gpu/shaderVariant.ts';
import { setReach } from './reach.ts';
import type { Style } from './style.ts';

/** Shaders declare its functions next to each other. */
const FALLOFF: AddedCode = { define: 'FALLOFF', declared: 'FALLOFF', code };

/** Shaders as {@link LampLight} draws them. */
export function withFalloff(shaders: Shaders): Shaders {
  return withCode(shaders, FALLOFF);
}

/** The light of a lamp on one smoke and its surfaces: shaders/falloff/falloff.glsl and what it reads. */
export class LampLight extends ShaderVariant {
  private readonly uniforms;
  /** Ramps in the light of the style, which the GPU decodes. */
  private readonly ramps: RampTexture;

  constructor() {
    const ramps = new RampTexture(1);
    ramps.texture.colorSpace = SRGBColorSpace;
    const uniforms = {
      lampPlace: { value: new Vector3() },
      lampLight: { value: new ThreeColor() },
      lampStrength: { value: 0 },
      ambientLight: { value: new ThreeColor() },
      lampRim: { value: new ThreeColor() },
      lampReach: { value: new Vector4() },
      lampCone: { value: new Vector4() },
      styledRamps: { value: ramps.texture },
    } satisfies Record<string, IUniform>;
    super(FALLOFF, uniforms);
    this.uniforms = uniforms;
    this.ramps = ramps;
  }

  /** @param ramps of all materials, in order */
  apply({ lampLight = [0, 0, 0], illumination, rimColor }: Style, ramps: readonly Ramp[]): void {
    const { uniforms } = this;
    const strength = Math.max(...lampLight);
    const light = lampLight.map((factor) => factor / (strength || 1));
    uniforms.lampStrength.value = strength;
    uniforms.lampLight.value.fromArray(light);
    uniforms.ambientLight.value.fromArray(illumination.ambient);
    uniforms.lampRim.value.fromArray(linear(rimColor).map((channel, at) => channel * light[at]));
    this.ramps.resize(ramps.length);
    // What glows by itself has no light.
    ramps.forEach((ramp, material) => this.ramps.write(material, ramp.glows ? { ...ramp, glow: 1 } : ramp));
  }

  /** Sets the place of the lamp in the world, and how its light weakens. */
  look(place: Vector3, falloff?: Falloff): void {
    const { lampPlace, lampReach, lampCone } = this.uniforms;
    lampPlace.value.copy(place);
    setReach(lampReach.value, lampCone.value, falloff);
  }

  dispose(): void {
    this.ramps.dispose();
  }
}
