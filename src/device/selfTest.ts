import {
  BufferAttribute,
  BufferGeometry,
  GLSL3,
  LessEqualDepth,
  Mesh,
  NearestFilter,
  NoBlending,
  RawShaderMaterial,
  Scene,
  WebGLRenderTarget,
  type WebGLRenderer,
} from 'three';
import { PassCamera } from './passCamera.ts';
import fragmentShader from '../../shaders/selfTest/selfTest.frag';
import vertexShader from '../../shaders/selfTest/selfTest.vert';

/** The program of the test, which takes longer to compile than to draw. */
export const SELF_TEST_SHADERS = { vertexShader, fragmentShader };

const [WIDTH, HEIGHT] = [16, 8];
/** Between the values of right and wrong pixels, 255 and 128. Some browsers falsify bits of what pages read. */
const RIGHT = 192;
/** Share of wrong values from which the depth test is wrong; a wrong half has all of them. */
const WRONG_SHARE = 1 / 16;

/**
 * A rectangle over one half of the target: its geometric depth, the depth that its fragments write, and its grey level.
 */
interface Rectangle {
  half: 'left' | 'right';
  polygonDepth: number;
  writtenDepth: number;
  tone: number;
}

/**
 * On the left, the second rectangle is behind the first, but its fragments write a smaller depth. On the right, it is
 * in front and its fragments write a larger depth. An early depth test gives the wrong result in both halves.
 */
const RECTANGLES: readonly Rectangle[] = [
  { half: 'left', polygonDepth: 0.25, writtenDepth: 0.75, tone: 0.5 },
  { half: 'right', polygonDepth: 0.9, writtenDepth: 0.25, tone: 1 },
  { half: 'left', polygonDepth: 0.9, writtenDepth: 0.5, tone: 1 },
  { half: 'right', polygonDepth: 0.1, writtenDepth: 0.5, tone: 0.5 },
];

/**
 * Whether the depth test uses the depth that fragments write. Some GPUs keep the early depth test on (Intel HD 620 and
 * 630 among them). The test draws and reads pixels instead of matching GPU names. It restores the state of the
 * renderer.
 */
export function keepsWrittenDepth(renderer: WebGLRenderer): boolean {
  const target = new WebGLRenderTarget(WIDTH, HEIGHT, { minFilter: NearestFilter, magFilter: NearestFilter });
  const isReversed = renderer.state.buffers.depth.getReversed();
  const mesh = new Mesh(rectangles(isReversed), testMaterial());
  mesh.frustumCulled = false;
  const before = { target: renderer.getRenderTarget(), autoClear: renderer.autoClear };
  renderer.autoClear = false;
  renderer.setRenderTarget(target);
  renderer.clear(true, true, false);
  renderer.render(new Scene().add(mesh), new PassCamera());
  const pixels = new Uint8Array(4 * WIDTH * HEIGHT);
  renderer.readRenderTargetPixels(target, 0, 0, WIDTH, HEIGHT, pixels);
  renderer.setRenderTarget(before.target);
  renderer.autoClear = before.autoClear;
  for (const part of [target, mesh.geometry, mesh.material]) part.dispose();
  return pixels.filter((value) => value < RIGHT).length < WRONG_SHARE * pixels.length;
}

/** @param isReversed whether the near plane has window depth 1 and clip space depth is 0 to 1 */
function rectangles(isReversed: boolean): BufferGeometry {
  const geometry = new BufferGeometry();
  const corners = RECTANGLES.flatMap((rectangle) => {
    const [left, right] = rectangle.half === 'left' ? [-1, 0] : [0, 1];
    return [left, -1, right, -1, right, 1, left, 1];
  });
  const ofAll = (valuesOf: (rectangle: Rectangle) => number[]) =>
    new Float32Array(RECTANGLES.flatMap((rectangle) => Array.from({ length: 4 }, () => valuesOf(rectangle)).flat()));
  const depths = ofAll(({ polygonDepth, writtenDepth }) =>
    isReversed ? [1 - polygonDepth, 1 - writtenDepth] : [2 * polygonDepth - 1, writtenDepth],
  );
  geometry.setAttribute('place', new BufferAttribute(new Float32Array(corners), 2));
  geometry.setAttribute('depths', new BufferAttribute(depths, 2));
  geometry.setAttribute(
    'tone',
    new BufferAttribute(
      ofAll(({ tone }) => [tone]),
      1,
    ),
  );
  geometry.setIndex(RECTANGLES.flatMap((_, number) => [0, 1, 2, 0, 2, 3].map((corner) => 4 * number + corner)));
  return geometry;
}

function testMaterial(): RawShaderMaterial {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    ...SELF_TEST_SHADERS,
    uniforms: { minTone: { value: 0.25 } },
    depthFunc: LessEqualDepth,
    blending: NoBlending,
  });
}
