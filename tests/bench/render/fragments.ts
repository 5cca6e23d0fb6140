/** Counts fragments: draws a pass once more, each fragment adding one to its pixel, and sums the picture. */
import {
  Camera,
  CustomBlending,
  FloatType,
  GLSL3,
  Mesh,
  NearestFilter,
  OneFactor,
  RawShaderMaterial,
  Scene,
  WebGLRenderTarget,
  type InstancedBufferGeometry,
  type WebGLRenderer,
} from 'three';

/** What a pass covers. */
export interface Fragments {
  /** Fragments that the shader ran for. */
  rasterised: number;
  /** Those of them that were not discarded; depth and stencil are not asked. */
  kept: number;
}

/**
 * @param geometry as filled for the last frame
 * @param material the pass's own, with the uniforms of the last frame
 */
export function countFragments(
  renderer: WebGLRenderer,
  geometry: InstancedBufferGeometry,
  material: RawShaderMaterial,
  width: number,
  height: number,
): Fragments {
  const count = (fragmentShader: string) =>
    sumOf(renderer, geometry, counting(material, fragmentShader), width, height);
  return { rasterised: count(ONE_EACH), kept: count(addingOne(material.fragmentShader)) };
}

const ONE_EACH = 'precision highp float; layout(location = 0) out vec4 one; void main() { one = vec4(1.0); }';

/** The pass's own shader, discards included, whose first output becomes 1. */
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
  geometry: InstancedBufferGeometry,
  material: RawShaderMaterial,
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
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  renderer.setRenderTarget(target);
  renderer.setClearColor(0x000000, 0);
  renderer.clear(true, false, false);
  renderer.render(new Scene().add(mesh), new Camera());
  const pixels = new Float32Array(4 * width * height);
  renderer.readRenderTargetPixels(target, 0, 0, width, height, pixels);
  renderer.setRenderTarget(null);
  target.dispose();
  material.dispose();
  return pixels.reduce((sum, value, index) => (index % 4 === 0 ? sum + value : sum), 0);
}
