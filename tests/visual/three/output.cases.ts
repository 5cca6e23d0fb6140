/** Outputs of smoke (canvas, render targets, several viewports), and the renderer state after a frame. */
import { Color, HalfFloatType, Vector4, WebGLRenderTarget, type Mesh, type MeshBasicMaterial } from 'three';
import {
  changedPixels,
  dispose,
  draw,
  furnishedHost,
  HANGING,
  HEIGHT,
  makeRenderer,
  readCanvas,
  smokeIn,
  smokePixels,
  WIDTH,
  type Host,
  type Pixels,
} from './scene.ts';
import type { Values } from '../../../src/parameters/parameter.ts';

const PARAMETERS = [
  'VIEWPORT SCISSOR_BOX SCISSOR_TEST DEPTH_TEST DEPTH_FUNC DEPTH_WRITEMASK DEPTH_CLEAR_VALUE',
  'STENCIL_TEST STENCIL_CLEAR_VALUE COLOR_CLEAR_VALUE COLOR_WRITEMASK BLEND CULL_FACE FRONT_FACE',
  'POLYGON_OFFSET_FILL SAMPLE_ALPHA_TO_COVERAGE FRAMEBUFFER_BINDING READ_FRAMEBUFFER_BINDING',
]
  .join(' ')
  .split(' ');

/** State of a renderer and its WebGL context between two frames. */
function stateOf({ renderer, scene, keyLight }: Host): Record<string, unknown> {
  const gl = renderer.getContext() as unknown as Record<string, number> & WebGL2RenderingContext;
  const held = PARAMETERS.map((name) => [name, String(gl.getParameter(gl[name]))]);
  const { autoClear, autoClearStencil, sortObjects, toneMapping, outputColorSpace, localClippingEnabled } = renderer;
  const { autoUpdate, needsUpdate } = renderer.shadowMap;
  const materials: boolean[] = [];
  scene.traverse((object) =>
    'isMesh' in object ? materials.push(((object as Mesh).material as MeshBasicMaterial).visible) : 0,
  );
  return {
    ...Object.fromEntries(held),
    autoClear,
    autoClearStencil,
    sortObjects,
    toneMapping,
    outputColorSpace,
    localClippingEnabled,
    autoUpdate,
    needsUpdate,
    autoReset: renderer.info.autoReset,
    target: renderer.getRenderTarget(),
    clearColor: `${renderer.getClearColor(new Color()).getHexString()} ${renderer.getClearAlpha()}`,
    viewport: renderer.getViewport(new Vector4()).toArray().join(),
    background: (scene.background as Color).getHexString(),
    worldAutoUpdate: scene.matrixWorldAutoUpdate,
    intensity: keyLight.intensity,
    materials: materials.join(),
  };
}

/**
 * The state after a frame without smoke and after one with it, and the difference of frames without smoke before and
 * after.
 * @param place the canvas or a target without stencil
 */
export async function stateAsFound(
  place: 'canvas' | 'target',
): Promise<{ before: object; after: object; changed: number; drawn: number }> {
  const host = furnishedHost();
  const target = new WebGLRenderTarget(WIDTH, HEIGHT, { samples: 4 });
  if (place === 'target') host.renderer.setRenderTarget(target);
  host.renderer.setClearColor('#123456', 0.5);
  host.renderer.shadowMap.enabled = true;
  host.keyLight.castShadow = true;
  host.scene.traverse((object) => ('isMesh' in object ? (object.castShadow = object.receiveShadow = true) : false));
  const untouched = drawHere(host);
  const before = stateOf(host);
  const smoke = await smokeIn(host);
  drawHere(host);
  await smoke.complete();
  const drawn = changedPixels(drawHere(host), untouched);
  host.scene.remove(smoke);
  const after = stateOf(host);
  const changed = changedPixels(drawHere(host), untouched);
  dispose(smoke, target, host.renderer);
  return { before, after, changed, drawn };
}

/** Draws into the current target. */
function drawHere(host: Host): Pixels {
  const { renderer } = host;
  const target = renderer.getRenderTarget();
  if (!target) return draw(host);
  renderer.render(host.scene, host.camera);
  const pixels = new Uint8Array(4 * WIDTH * HEIGHT);
  renderer.readRenderTargetPixels(target, 0, 0, WIDTH, HEIGHT, pixels);
  return pixels;
}

/** Two cameras share a canvas: difference of each half from the picture of its camera alone. */
export async function twoCameras(): Promise<{ left: number; right: number; between: number; sameState: boolean }> {
  const size = [WIDTH / 2, HEIGHT] as const;
  const [pair, single] = [furnishedHost(), furnishedHost(makeRenderer({}, [...size]))];
  const cameras = [0.4, -2.5].map((x) => {
    const camera = pair.camera.clone();
    camera.aspect = size[0] / size[1];
    camera.updateProjectionMatrix();
    camera.position.x = x;
    camera.lookAt(0, 0.8, 0);
    return camera;
  });
  const smokes = [await smokeIn(pair), await smokeIn(single)];
  const state = smokes[0].hash();
  pair.renderer.setScissorTest(true);
  cameras.forEach((camera, index) => {
    pair.renderer.setViewport(index * size[0], 0, ...size);
    pair.renderer.setScissor(index * size[0], 0, ...size);
    pair.renderer.render(pair.scene, camera);
  });
  const both = readCanvas(pair.renderer);
  const halves = [0, 1].map((half) => both.filter((_, at) => Math.floor(((at / 4) % WIDTH) / size[0]) === half));
  const alone = cameras.map((camera) => draw({ ...single, camera }));
  const sameState = smokes[0].hash() === state;
  dispose(...smokes, pair.renderer, single.renderer);
  const [left, right] = halves.map((half, index) => changedPixels(half, alone[index]));
  return { left, right, between: changedPixels(halves[0], halves[1]), sameState };
}

export interface TwoSmokes {
  /** Pixels inside the lower smoke and beside the upper one, and those of them that the upper one changes. */
  lower: number;
  changed: number;
  /** Pixels beside both that only one of them shadows, and pixels that are not as dark as the darker of their two pictures. */
  shadow: number;
  wrong: number;
}

/** Two smokes, one between the light and the other. */
export async function twoSmokes(): Promise<TwoSmokes> {
  const host = furnishedHost();
  // The lights and the floor: no object is in front of smoke.
  host.scene.remove(...host.scene.children.slice(3));
  // Outlines close where the smokes touch.
  const plain: Values = { ...HANGING, 'style.outlines': 0 };
  const lower = await smokeIn(host, plain);
  const towardsLight = { 'emitters.0.position.x': 0.7, 'emitters.0.position.y': 1.95, 'emitters.0.position.z': 0.45 };
  const upper = await smokeIn(host, { ...plain, ...towardsLight });
  const pictures = [[lower], [upper], [lower, upper]].map((shown) => {
    for (const smoke of [lower, upper]) smoke.visible = shown.includes(smoke);
    return draw(host);
  });
  for (const smoke of [lower, upper]) smoke.visible = true;
  const [isLower, isUpper] = [lower, upper].map((smoke) => smokePixels(host, smoke));
  const [one, other, both] = pictures.map((pixels) =>
    Array.from({ length: WIDTH * HEIGHT }, (_, pixel) => pixels.subarray(4 * pixel, 4 * pixel + 3)),
  );
  const lightOf = (color: Pixels) => color.reduce((sum, value) => sum + value, 0);
  const seen = { lower: 0, changed: 0, shadow: 0, wrong: 0 };
  both.forEach((color, pixel) => {
    // The edges of smoke are mixed with what is behind them.
    const beside = [-1, 0, 1, -WIDTH, WIDTH].map((step) => pixel + step);
    if (beside.some((each) => isUpper[each] || isLower[each] !== isLower[pixel])) return;
    const darker = lightOf(one[pixel]) < lightOf(other[pixel]) ? one[pixel] : other[pixel];
    if (isLower[pixel]) {
      seen.lower += 1;
      seen.changed += String(color) === String(one[pixel]) ? 0 : 1;
      return;
    }
    seen.shadow += String(one[pixel]) === String(other[pixel]) ? 0 : 1;
    seen.wrong += String(color) === String(darker) ? 0 : 1;
  });
  dispose(lower, upper, host.renderer);
  return seen;
}

/** The picture in a linear half-float target, encoded in the test, compared with the canvas. */
export async function inTarget(samples: number): Promise<{ changed: number; smoke: number }> {
  const host = furnishedHost(makeRenderer({ antialias: samples > 0 }));
  const before = draw(host);
  const smoke = await smokeIn(host);
  const onCanvas = draw(host);
  const target = new WebGLRenderTarget(WIDTH, HEIGHT, { type: HalfFloatType, stencilBuffer: true, samples });
  host.renderer.setRenderTarget(target);
  host.renderer.render(host.scene, host.camera);
  const halves = new Uint16Array(4 * WIDTH * HEIGHT);
  host.renderer.readRenderTargetPixels(target, 0, 0, WIDTH, HEIGHT, halves);
  smoke.update(0);
  target.dispose();
  dispose(smoke, host.renderer);
  return { changed: changedPixels(encoded(halves), onCanvas, 2), smoke: changedPixels(onCanvas, before) };
}

const RENDERERS = {
  outputBuffer: { outputBufferType: HalfFloatType },
  reversedDepth: { reversedDepthBuffer: true },
} as const;

/** The canvas of a renderer with a half-float output buffer or a reversed depth buffer, compared with one without. */
export async function otherRenderer(kind: keyof typeof RENDERERS): Promise<number> {
  const pictures: Pixels[] = [];
  for (const parameters of [{}, RENDERERS[kind]]) {
    const host = furnishedHost(makeRenderer(parameters));
    const smoke = await smokeIn(host);
    pictures.push(draw(host));
    smoke.update(0);
    dispose(smoke, host.renderer);
  }
  return changedPixels(pictures[0], pictures[1], 2);
}

/** Linear half floats as display-encoded bytes. */
export function encoded(halves: Uint16Array): Pixels {
  const view = new DataView(new ArrayBuffer(2));
  return Uint8Array.from(halves, (half, at) => {
    view.setUint16(0, half);
    const value = Math.min(
      1,
      (view as unknown as { getFloat16?: (at: number) => number }).getFloat16?.(0) ?? fromHalf(half),
    );
    const display = at % 4 === 3 ? value : value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055;
    return Math.round(255 * display);
  });
}

function fromHalf(half: number): number {
  const exponent = (half >> 10) & 31;
  const fraction = half & 1023;
  return exponent === 0 ? fraction * 2 ** -24 : (1 + fraction / 1024) * 2 ** (exponent - 15);
}
