import {
  BufferGeometry,
  GLSL3,
  LessEqualDepth,
  NearestFilter,
  NoBlending,
  RawShaderMaterial,
  WebGLRenderTarget,
  type WebGLRenderer,
} from 'three';
import { DrawnMesh } from './drawnMesh.ts';
import fragmentShader from '../../../shaders/selfTest/selfTest.frag';
import vertexShader from '../../../shaders/selfTest/selfTest.vert';

/** The program of the test, which takes longer to compile than to draw. */
export const SELF_TEST_SHADERS = { vertexShader, fragmentShader };

const [WIDTH, HEIGHT] = [16, 8];
/** Vertices of all rectangles. */
const VERTICES = 24;
/** Between the values of right and wrong pixels, 255 and 128. Some browsers falsify bits of what pages read. */
const RIGHT = 192;
/** Share of wrong values from which the depth test is wrong; a wrong half has all of them. */
const WRONG_SHARE = 1 / 16;

/**
 * Whether the depth test uses the depth that fragments write. Some GPUs keep the early depth test on (Intel HD 620 and
 * 630 among them). The test draws and reads pixels instead of matching GPU names. It restores the state of the
 * renderer.
 * @returns a function that reads the result once, which waits for the GPU
 */
export function drawDepthTest(renderer: WebGLRenderer): () => boolean {
  const target = new WebGLRenderTarget(WIDTH, HEIGHT, { minFilter: NearestFilter, magFilter: NearestFilter });
  const geometry = new BufferGeometry();
  geometry.setDrawRange(0, VERTICES);
  const material = testMaterial(renderer.state.buffers.depth.getReversed());
  const before = { target: renderer.getRenderTarget(), autoClear: renderer.autoClear };
  renderer.autoClear = false;
  renderer.setRenderTarget(target);
  renderer.clear(true, true, false);
  new DrawnMesh(material, geometry).draw(renderer);
  renderer.setRenderTarget(before.target);
  renderer.autoClear = before.autoClear;
  return () => {
    const pixels = new Uint8Array(4 * WIDTH * HEIGHT);
    renderer.readRenderTargetPixels(target, 0, 0, WIDTH, HEIGHT, pixels);
    for (const part of [target, geometry, material]) part.dispose();
    return pixels.filter((value) => value < RIGHT).length < WRONG_SHARE * pixels.length;
  };
}

function testMaterial(isReversed: boolean): RawShaderMaterial {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    ...SELF_TEST_SHADERS,
    uniforms: { minTone: { value: 0.25 }, isReversed: { value: isReversed } },
    depthFunc: LessEqualDepth,
    blending: NoBlending,
  });
}
