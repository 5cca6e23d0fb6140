/** Materials with more code, for light and patterns that few smokes have. */
import type { IUniform, RawShaderMaterial } from 'three';
import { withCodeBeforeMain, type Shaders } from './programsAhead.ts';

/** Code that shaders with a define declare and call. */
export interface AddedCode {
  /** The define; only programs that contain its name change. */
  readonly define: string;
  /** A function of the code, which shaders that need it declare. */
  readonly declared: string;
  readonly code: string;
}

/** Variants of materials with more code. */
export class ShaderVariant {
  private readonly variants = new WeakMap<RawShaderMaterial, RawShaderMaterial>();
  private readonly code: AddedCode;
  private readonly added: Record<string, IUniform>;

  constructor(code: AddedCode, uniforms: Record<string, IUniform>) {
    this.code = code;
    this.added = uniforms;
  }

  /** A variant of a material, with the same uniforms; the material itself if it has no use for the code. */
  on(material: RawShaderMaterial): RawShaderMaterial {
    const variant = this.variants.get(material) ?? this.make(material);
    this.variants.set(material, variant);
    return variant;
  }

  private make(whole: RawShaderMaterial): RawShaderMaterial {
    const shaders = withCode(whole, this.code);
    if (shaders === whole) return whole;
    const { uniforms } = whole;
    // clone() would copy them.
    whole.uniforms = {};
    const variant = whole.clone();
    whole.uniforms = uniforms;
    Object.assign(variant, shaders, { uniforms: { ...uniforms, ...this.added } });
    whole.addEventListener('dispose', () => variant.dispose());
    return variant;
  }
}

/** Shaders with more code; the same object if they have no use for it. */
export function withCode(shaders: Shaders, { define, declared, code }: AddedCode): Shaders {
  const { vertexShader, fragmentShader, defines } = shaders;
  if (![vertexShader, fragmentShader].some((shader) => shader.includes(define))) return shaders;
  // Vertex shaders of surfaces and of whole pictures have no use for it.
  const added = (shader: string) => (shader.includes(declared) ? withCodeBeforeMain(shader, code) : shader);
  return {
    vertexShader: added(vertexShader),
    fragmentShader: added(fragmentShader),
    defines: { ...defines, [define]: '' },
  };
}
