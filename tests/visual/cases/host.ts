/** Smoke in a stranger's scene, against the same scene without it. */
import {
  ACESFilmicToneMapping,
  ArrayCamera,
  BoxGeometry,
  Color,
  HalfFloatType,
  HemisphereLight,
  Mesh,
  MeshBasicMaterial,
  NoToneMapping,
  PlaneGeometry,
  Scene,
  SphereGeometry,
  Sprite,
  SpriteMaterial,
  Vector3,
  Vector4,
  WebGLRenderTarget,
  type Object3D,
  type WebGLRenderer,
} from 'three';
import type { CartoonSmoke } from '../../../src/host/cartoonSmoke.ts';
import {
  changedPixels,
  differences,
  dispose,
  draw,
  drawUnlit,
  emptyHost,
  furnishedHost,
  HANGING,
  HEIGHT,
  makeInstanced,
  makeRenderer,
  makeSkinned,
  readCanvas,
  smokeIn,
  WIDTH,
  type Host,
  type Pixels,
} from './hostScene.ts';

/** How the pixels beside the smoke are, once it is there. */
export interface Census {
  /** As they were. */
  lit: number;
  /** As they are without the key light, which is not as they were. */
  dark: number;
  /** Partly so and partly so, along an edge that the canvas smooths. */
  between: number;
  wrong: number;
}

/** A furnished scene before and after smoke comes into it. */
export async function lightAndShadow(antialias: boolean, toneMapped: boolean): Promise<Census> {
  const toneMapping = toneMapped ? ACESFilmicToneMapping : NoToneMapping;
  const host = furnishedHost(makeRenderer({ antialias }, undefined, toneMapping));
  const [before, unlit] = [draw(host), drawUnlit(host)];
  const smoke = await smokeIn(host);
  const census = censusOf(before, unlit, draw(host), maskOf(host, smoke));
  dispose(smoke, host.renderer);
  return census;
}

function censusOf(before: Pixels, unlit: Pixels, after: Pixels, isSmoke: readonly boolean[]): Census {
  const census = { lit: 0, dark: 0, between: 0, wrong: 0 };
  const [toBefore, toUnlit] = [differences(after, before), differences(after, unlit)];
  isSmoke.forEach((smoke, pixel) => {
    if (smoke) return;
    if (toBefore[pixel] === 0) ++census.lit;
    else if (toUnlit[pixel] === 0) ++census.dark;
    else if (isBetween(after, before, unlit, pixel)) ++census.between;
    else ++census.wrong;
  });
  return census;
}

function isBetween(value: Pixels, a: Pixels, b: Pixels, pixel: number): boolean {
  return [0, 1, 2, 3].every((channel) => {
    const at = 4 * pixel + channel;
    return value[at] >= Math.min(a[at], b[at]) - 1 && value[at] <= Math.max(a[at], b[at]) + 1;
  });
}

/** Where smoke is, alone in front of one colour. */
function smokePixels(host: Host, smoke: CartoonSmoke): boolean[] {
  const scene = new Scene();
  scene.background = new Color('#ff00ff');
  scene.add(smoke);
  const pixels = draw({ ...host, scene });
  host.scene.add(smoke);
  return Array.from({ length: WIDTH * HEIGHT }, (_, pixel) => pixels[4 * pixel + 1] !== 0);
}

/** Where smoke is, and one pixel around it. */
function maskOf(host: Host, smoke: CartoonSmoke): boolean[] {
  const isSmoke = smokePixels(host, smoke);
  return isSmoke.map((_, pixel) => [0, 1, -1, WIDTH, -WIDTH].some((step) => isSmoke[pixel + step]));
}

/** Pixels that differ between a deformed mesh among smoke and the same triangles as an ordinary mesh. */
export async function deformed(
  kind: 'skinned' | 'instanced',
): Promise<{ changed: number; hidden: number; shown: number }> {
  const host = emptyHost();
  const red = new MeshBasicMaterial({ color: '#ff0000' });
  const mesh = kind === 'skinned' ? makeSkinned(red).mesh : makeInstanced(red);
  mesh.position.y += kind === 'skinned' ? 0.4 : 0.1;
  host.scene.add(mesh);
  const alone = draw(host);
  const smoke = await smokeIn(host);
  const pixels = draw(host);
  host.scene.remove(mesh);
  host.scene.add(kind === 'skinned' ? frozen(mesh as never) : separate(mesh as never));
  const ordinary = draw(host);
  dispose(smoke, host.renderer);
  const isRed = (picture: Pixels, pixel: number) => picture[4 * pixel] === 255 && picture[4 * pixel + 1] === 0;
  const covered = Array.from({ length: WIDTH * HEIGHT }, (_, pixel) => pixel).filter((pixel) => isRed(alone, pixel));
  const shown = covered.filter((pixel) => isRed(pixels, pixel)).length;
  return { changed: changedPixels(pixels, ordinary), hidden: covered.length - shown, shown };
}

function frozen(mesh: ReturnType<typeof makeSkinned>['mesh']): Mesh {
  const geometry = mesh.geometry.clone();
  const { position } = geometry.attributes;
  const place = new Vector3();
  mesh.updateWorldMatrix(true, true);
  mesh.skeleton.update();
  for (let vertex = 0; vertex < position.count; ++vertex) {
    mesh.getVertexPosition(vertex, place);
    position.setXYZ(vertex, place.x, place.y, place.z);
  }
  const copy = new Mesh(geometry, mesh.material);
  copy.position.copy(mesh.position);
  return copy;
}

function separate(mesh: ReturnType<typeof makeInstanced>): Object3D {
  const parts = Array.from({ length: mesh.count }, (_, index) => {
    const part = new Mesh(mesh.geometry, mesh.material);
    mesh.getMatrixAt(index, part.matrix);
    part.matrix.decompose(part.position, part.quaternion, part.scale);
    return part;
  });
  const group = new Mesh();
  group.material = new MeshBasicMaterial({ visible: false });
  group.position.copy(mesh.position);
  return group.add(...parts);
}

/** Share of the smoke that a blended object of half opacity tints: when it stands before, within and behind the smoke. */
export async function blended(
  kind: 'pane' | 'sprite',
): Promise<{ before: number; within: number; behind: number; wrong: number }> {
  const host = emptyHost();
  const smoke = await smokeIn(host);
  const untouched = draw(host);
  const mask = smokePixels(host, smoke);
  const thing = kind === 'pane' ? pane() : sprite();
  host.scene.add(thing);
  let wrong = 0;
  const forward = new Vector3(0, 1.2, 0).sub(host.camera.position).normalize();
  const tinted = [-1.2, 0, 1.2].map((along) => {
    thing.position.set(0, 1.2, 0).addScaledVector(forward, along);
    thing.lookAt(host.camera.position);
    const pixels = draw(host);
    const inner = mask.flatMap((isSmoke, pixel) => (isSmoke && !isEdge(mask, pixel) ? [pixel] : []));
    const isTinted = inner.filter((pixel) => differs(pixels, untouched, pixel));
    wrong += isTinted.filter((pixel) => !isHalfGreen(pixels, untouched, pixel)).length;
    return isTinted.length / inner.length;
  });
  dispose(smoke, host.renderer);
  return { before: tinted[0], within: tinted[1], behind: tinted[2], wrong };
}

const HALF_GREEN = { color: '#00ff00', opacity: 0.5, transparent: true } as const;

function pane(): Mesh {
  return new Mesh(new PlaneGeometry(3, 3), new MeshBasicMaterial(HALF_GREEN));
}

function sprite(): Sprite {
  const thing = new Sprite(new SpriteMaterial(HALF_GREEN));
  thing.scale.setScalar(3);
  return thing;
}

function isEdge(mask: readonly boolean[], pixel: number): boolean {
  return [1, -1, WIDTH, -WIDTH, 2, -2, 2 * WIDTH, -2 * WIDTH].some((step) => !mask[pixel + step]);
}

function differs(a: Pixels, b: Pixels, pixel: number): boolean {
  return [0, 1, 2].some((channel) => a[4 * pixel + channel] !== b[4 * pixel + channel]);
}

function isHalfGreen(tinted: Pixels, plain: Pixels, pixel: number): boolean {
  return [0, 255, 0].every(
    (green, channel) => Math.abs(tinted[4 * pixel + channel] - (plain[4 * pixel + channel] + green) / 2) <= 1,
  );
}

const PARAMETERS = [
  'VIEWPORT SCISSOR_BOX SCISSOR_TEST DEPTH_TEST DEPTH_FUNC DEPTH_WRITEMASK DEPTH_CLEAR_VALUE',
  'STENCIL_TEST STENCIL_CLEAR_VALUE COLOR_CLEAR_VALUE COLOR_WRITEMASK BLEND CULL_FACE FRONT_FACE',
  'POLYGON_OFFSET_FILL SAMPLE_ALPHA_TO_COVERAGE FRAMEBUFFER_BINDING',
]
  .join(' ')
  .split(' ');

/** What a renderer and its context hold between two frames. */
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

/** The state after a frame without smoke and after one with it, and how a frame without it looks before and after. */
export async function stateAsFound(): Promise<{ before: object; after: object; changed: number; drawn: number }> {
  const host = furnishedHost();
  host.renderer.setClearColor('#123456', 0.5);
  host.renderer.shadowMap.enabled = true;
  host.keyLight.castShadow = true;
  host.scene.traverse((object) => ('isMesh' in object ? (object.castShadow = object.receiveShadow = true) : false));
  const untouched = draw(host);
  const before = stateOf(host);
  const smoke = await smokeIn(host);
  const drawn = changedPixels(draw(host), untouched);
  host.scene.remove(smoke);
  const after = stateOf(host);
  const changed = changedPixels(draw(host), untouched);
  dispose(smoke, host.renderer);
  return { before, after, changed, drawn };
}

/** Two cameras share a canvas; how far each half is from the picture that its camera draws alone. */
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

/** How far the picture in a linear half float target, encoded here, is from the canvas: most pixels, and the worst of them. */
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

/** The canvas of a renderer that draws all into a half float buffer of its own first, against one that does not. */
export async function inOutputBuffer(): Promise<number> {
  const pictures: Pixels[] = [];
  for (const parameters of [{}, { outputBufferType: HalfFloatType }] as const) {
    const host = furnishedHost(makeRenderer(parameters));
    const smoke = await smokeIn(host);
    pictures.push(draw(host));
    smoke.update(0);
    dispose(smoke, host.renderer);
  }
  return changedPixels(pictures[0], pictures[1], 2);
}

function encoded(halves: Uint16Array): Pixels {
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

/** Floor pixels that smoke leaves lit, and that an object darkens: with the balls or the silhouette that it casts. */
export async function casting(kind: 'mesh' | 'skinned' | 'instanced'): Promise<Census> {
  const host = furnishedHost();
  const thing =
    kind === 'mesh'
      ? new Mesh(new BoxGeometry(0.8, 0.6, 0.6), new MeshBasicMaterial())
      : kind === 'skinned'
        ? makeSkinned(new MeshBasicMaterial()).mesh
        : makeInstanced(new MeshBasicMaterial());
  thing.position.set(0.9, 0.5, 0.9);
  thing.scale.set(1.5, 0.8, 1);
  host.scene.add(thing);
  // Unseen, so that only what it casts shows.
  thing.material = new MeshBasicMaterial({ colorWrite: false, depthWrite: false });
  const [before, unlit] = [draw(host), drawUnlit(host)];
  const smoke = await smokeIn(host, { ...HANGING, 'emission.rate': 0 });
  smoke.cast(thing);
  const census = censusOf(before, unlit, draw(host), Array<boolean>(WIDTH * HEIGHT).fill(false));
  dispose(smoke, host.renderer);
  return census;
}

/** Everything that is refused, and in which words. */
export async function refusals(): Promise<Record<string, string>> {
  const said: Record<string, string> = {};
  const attempt = async (name: string, act: () => unknown) => {
    try {
      await act();
      said[name] = 'nothing';
    } catch (error) {
      said[name] = `${(error as Error).name}: ${(error as Error).message}`;
    }
  };
  const create = (renderer: WebGLRenderer, more = {}) => smokeIn(emptyHost(renderer), HANGING, more);
  for (const [name, parameters] of Object.entries({
    stencil: { stencil: false },
    logarithmic: { logarithmicDepthBuffer: true },
    reversed: { reversedDepthBuffer: true },
  })) {
    const renderer = makeRenderer(parameters);
    await attempt(name, () => create(renderer));
    dispose(renderer);
  }
  const host = emptyHost();
  await attempt('light', () => create(host.renderer, { keyLight: new HemisphereLight() as never }));
  await attempt('preset', () => create(host.renderer, { preset: 'lampp' }));
  await attempt('value', () => create(host.renderer, { values: { 'emission.rate': -1 } }));
  const smoke = await smokeIn(host);
  await attempt('fixed', () => smoke.set({ seed: 2 }));
  await attempt('given', () => smoke.set({ 'light.azimuth': 20 }));
  await attempt('open', () => smoke.cast(new Mesh(new PlaneGeometry())));
  await attempt('physics', () => smoke.collide(new Mesh(new SphereGeometry())));
  const target = new WebGLRenderTarget(32, 32);
  host.renderer.setRenderTarget(target);
  host.renderer.render(host.scene, host.camera);
  await attempt('target', () => smoke.update(0));
  host.renderer.setRenderTarget(null);
  const array = new ArrayCamera([Object.assign(host.camera.clone(), { viewport: new Vector4(0, 0, 50, 50) })]);
  array.projectionMatrix.copy(host.camera.projectionMatrix);
  host.renderer.render(host.scene, array);
  await attempt('array', () => smoke.update(0));
  await attempt('again', () => smoke.update(0));
  smoke.dispose();
  smoke.dispose();
  await attempt('disposed', () => smoke.update(0));
  target.dispose();
  dispose(host.renderer);
  return said;
}
