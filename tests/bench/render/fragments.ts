/** Counts fragments: draws a pass once more with additive blending of 1 per fragment, and sums the picture. */
import {
  CustomBlending,
  FloatType,
  GLSL3,
  NearestFilter,
  OneFactor,
  RawShaderMaterial,
  WebGLRenderTarget,
  type WebGLRenderer,
} from 'three';

/** The fragments of a pass. */
export interface Fragments {
  /** Invocations of the fragment shader. */
  rasterised: number;
  /** Fragments that are not discarded, without depth and stencil test. */
  kept: number;
}

/** Repeats the last draw of a pass with a material. */
export type Redraw = (material: RawShaderMaterial) => void;

/**
 * @param material of the pass, with the uniforms of the last frame
 * @param redraw repeats the draw call of the last frame
 */
export function countFragments(
  renderer: WebGLRenderer,
  material: RawShaderMaterial,
  redraw: Redraw,
  width: number,
  height: number,
): Fragments {
  const count = (fragmentShader: string) => sumOf(renderer, counting(material, fragmentShader), redraw, width, height);
  return { rasterised: count(ONE_EACH), kept: count(addingOne(material.fragmentShader)) };
}

const ONE_EACH = 'precision highp float; layout(location = 0) out vec4 one; void main() { one = vec4(1.0); }';

/** The shader of the pass, including discards, with 1 as its first output. */
function addingOne(source: string): string {
  const output = /layout\(location = 0\) out vec4 (\w+);/.exec(source)?.[1];
  const declaration = output === undefined ? 'layout(location = 0) out vec4 one;' : '';
  return `${source.replace('void main()', 'void shade()')}
    ${declaration}
    void main() { shade(); ${output ?? 'one'} = vec4(1.0); }`;
}

function counting(material: RawShaderMaterial, fragmentShader: string): RawShaderMaterial {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: material.vertexShader,
    fragmentShader,
    uniforms: material.uniforms,
    defines: material.defines,
    side: material.side,
    depthTest: false,
    depthWrite: false,
    transparent: true,
    blending: CustomBlending,
    blendSrc: OneFactor,
    blendDst: OneFactor,
  });
}

function sumOf(
  renderer: WebGLRenderer,
  material: RawShaderMaterial,
  redraw: Redraw,
  width: number,
  height: number,
): number {
  const gl = renderer.getContext();
  if (!gl.getExtension('EXT_color_buffer_float') || !gl.getExtension('EXT_float_blend')) {
    throw new Error('This context cannot add up floats, so fragments cannot be counted.');
  }
  const target = new WebGLRenderTarget(width, height, {
    type: FloatType,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    depthBuffer: false,
  });
  renderer.setRenderTarget(target);
  renderer.setClearColor(0x000000, 0);
  renderer.clear(true, false, false);
  redraw(material);
  const pixels = new Float32Array(4 * width * height);
  renderer.readRenderTargetPixels(target, 0, 0, width, height, pixels);
  renderer.setRenderTarget(null);
  target.dispose();
  material.dispose();
  return pixels.reduce((sum, value, index) => (index % 4 === 0 ? sum + value : sum), 0);
}
