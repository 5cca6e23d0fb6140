/** The light of lamps that weakens with distance, which few smokes have. */
import { Color as ThreeColor, SRGBColorSpace, Vector3, Vector4, type IUniform, type RawShaderMaterial } from 'three';
import code from '../../shaders/falloff/falloff.glsl';
import type { Falloff, WeakeningLight } from './gpu/frameView.ts';
import type { Shaders } from './gpu/programsAhead.ts';
import { linear, RampTexture, type Ramp } from './gpu/ramps.ts';
import { NEAREST } from './light.ts';
import type { Style } from './style.ts';

/** Least difference between the cosines of a cone. */
const SHARPEST = 1e-5;

/** The light of a lamp on one smoke and its surfaces: shaders/falloff/falloff.glsl and what it reads. */
export class LampLight implements WeakeningLight {
  /** Variants of materials for light that weakens. */
  private readonly variants = new WeakMap<RawShaderMaterial, RawShaderMaterial>();
  /** Ramps in the light of the style, which the GPU decodes. */
  private readonly ramps = new RampTexture(1);
  private readonly uniforms = {
    lampPlace: { value: new Vector3() },
    lampLight: { value: new ThreeColor() },
    lampStrength: { value: 0 },
    ambientLight: { value: new ThreeColor() },
    lampRim: { value: new ThreeColor() },
    lampReach: { value: new Vector4() },
    lampCone: { value: new Vector4() },
    styledRamps: { value: this.ramps.texture },
  } satisfies Record<string, IUniform>;

  constructor() {
    this.ramps.texture.colorSpace = SRGBColorSpace;
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
    ramps.forEach((ramp, material) => this.ramps.write(material, ramp));
  }

  look(place: Vector3, { decay, end = Infinity, cone, scale = 1 }: Falloff = { decay: 0 }): void {
    const { lampPlace, lampReach, lampCone } = this.uniforms;
    lampPlace.value.copy(place);
    lampReach.value.set(decay, scale / end, NEAREST / scale ** decay, scale ** -decay);
    lampCone.value.set(0, 0, 0, 1);
    if (!cone) return;
    const [edge, full] = cone.cosines;
    const sharpness = 1 / Math.max(full - edge, SHARPEST);
    const { x, y, z } = cone.axis.clone().multiplyScalar(sharpness);
    lampCone.value.set(x, y, z, -edge * sharpness);
  }

  /** A variant of a material, with the same uniforms. */
  on(material: RawShaderMaterial): RawShaderMaterial {
    const variant = this.variants.get(material) ?? this.make(material);
    this.variants.set(material, variant);
    return variant;
  }

  dispose(): void {
    this.ramps.dispose();
  }

  private make(whole: RawShaderMaterial): RawShaderMaterial {
    const { uniforms } = whole;
    // clone() would copy them.
    whole.uniforms = {};
    const variant = whole.clone();
    whole.uniforms = uniforms;
    Object.assign(variant, withFalloff(whole), { uniforms: { ...uniforms, ...this.uniforms } });
    whole.addEventListener('dispose', () => variant.dispose());
    return variant;
  }
}

/** Shaders for light that weakens; unchanged if they do not shade. */
export function withFalloff(shaders: Shaders): Shaders {
  const { vertexShader, fragmentShader, defines } = shaders;
  if (!fragmentShader.includes('FALLOFF')) return shaders;
  return {
    vertexShader: added(vertexShader),
    fragmentShader: added(fragmentShader),
    defines: { ...defines, FALLOFF: '' },
  };
}

/** Vertex shaders of surfaces and of whole pictures have no use for it. */
function added(shader: string): string {
  return shader.includes('FALLOFF') ? `${shader}\n${code}` : shader;
}
