/** Render targets without stencil: what post-processing, mirrors and cube cameras draw into. */
import {
  Color,
  CubeCamera,
  HalfFloatType,
  Mesh,
  MeshBasicMaterial,
  MeshNormalMaterial,
  PerspectiveCamera,
  PlaneGeometry,
  SphereGeometry,
  Vector2,
  type Vector3Tuple,
  WebGLCubeRenderTarget,
  WebGLRenderTarget,
} from 'three';
import { Reflector } from 'three/examples/jsm/objects/Reflector.js';
import { EffectComposer } from 'three/examples/jsm/postprocessing/EffectComposer.js';
import { GTAOPass } from 'three/examples/jsm/postprocessing/GTAOPass.js';
import { OutputPass } from 'three/examples/jsm/postprocessing/OutputPass.js';
import type { Pass } from 'three/examples/jsm/postprocessing/Pass.js';
import { RenderPass } from 'three/examples/jsm/postprocessing/RenderPass.js';
import { UnrealBloomPass } from 'three/examples/jsm/postprocessing/UnrealBloomPass.js';
import type { Values } from '../../../src/parameters/parameter.ts';
import type { CartoonSmoke } from '../../../src/three/cartoonSmoke.ts';
import { encoded } from './output.cases.ts';
import { censusOf, maskOf, type Census } from './shadow.cases.ts';
import {
  changedPixels,
  differences,
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

/** The furnished scene without the shader that ignores the colour space of its target. */
export function plainHost(samples: number): Host {
  const host = furnishedHost(makeRenderer({ antialias: samples > 0 }));
  host.scene.children.pop();
  return host;
}

/** Draws by the default composer, or by one whose target has samples. */
export function composed({ renderer, scene, camera }: Host, samples: number, ...passes: readonly Pass[]): () => Pixels {
  const target = new WebGLRenderTarget(WIDTH, HEIGHT, { type: HalfFloatType, samples });
  const composer = new EffectComposer(renderer, samples > 0 ? target : undefined);
  for (const pass of [new RenderPass(scene, camera), ...passes, new OutputPass()]) composer.addPass(pass);
  return () => {
    composer.render(0);
    return readCanvas(renderer);
  };
}

/** Mean difference of the channels of two pictures, as a share of white. */
export function meanDifference(a: Pixels, b: Pixels): number {
  return a.reduce((sum, value, at) => sum + Math.abs(value - b[at]), 0) / a.length / 255;
}

/** Shadow that a way of drawing shows, with the pictures of the same scene without smoke and without its key light. */
async function censusWith(host: Host, smoke: CartoonSmoke, picture: () => Pixels): Promise<Census> {
  const isSmoke = maskOf(host, smoke);
  const after = picture();
  host.scene.remove(smoke);
  const before = picture();
  const { intensity } = host.keyLight;
  host.keyLight.intensity = 0;
  const unlit = picture();
  host.keyLight.intensity = intensity;
  host.scene.add(smoke);
  return censusOf(before, unlit, after, isSmoke);
}

export interface Composed {
  census: Census;
  /** Mean differences from the canvas, with smoke and without it. */
  difference: number;
  bare: number;
  /** Pixels of the canvas that differ by more than 10 % of white. */
  distinct: number;
  errors: string[];
}

/** The scene by a composer and on the canvas. */
export async function byComposer(samples: number, values: Values = HANGING): Promise<Composed> {
  const host = plainHost(samples);
  const picture = composed(host, samples);
  const empty = { canvas: draw(host), composed: picture() };
  const smoke = await smokeIn(host, values);
  const errors: string[] = [];
  smoke.addEventListener('error', ({ error }) => errors.push(error.message));
  picture();
  await smoke.complete();
  const census = await censusWith(host, smoke, picture);
  const [canvas, shown] = [draw(host), picture()];
  smoke.update(0);
  dispose(smoke, host.renderer);
  return {
    census,
    difference: meanDifference(canvas, shown),
    bare: meanDifference(empty.canvas, empty.composed),
    distinct: changedPixels(canvas, shown, 25),
    errors,
  };
}

/** Smoke that a composer has drawn once. `census` draws again. */
export async function smokeWithoutStencil() {
  const host = plainHost(0);
  const picture = composed(host, 0);
  const smoke = await smokeIn(host);
  const errors: string[] = [];
  smoke.addEventListener('error', ({ error }) => errors.push(`${error.name}: ${error.message}`));
  picture();
  return { smoke, errors, census: () => censusWith(host, smoke, picture) };
}

/** What a target shows, compared with a camera at its place. */
export interface Seen {
  /** Mean difference, as a share of white. */
  difference: number;
  /** Pixels that differ by more than 10 % of white. */
  distinct: number;
  /** Pixels that smoke and its shadow change. */
  smoke: number;
}

/**
 * The picture in a mirror, and the number of black pixels of the mirror on the canvas.
 * @param light its position. By default the shadow of the smoke falls on the mirror
 */
export async function byMirror(
  values: Values = HANGING,
  light: Vector3Tuple = [1, 2, 5],
): Promise<Seen & { black: number }> {
  const host = plainHost(0);
  const mirror = new Reflector(new PlaneGeometry(6, 4), { textureWidth: WIDTH, textureHeight: HEIGHT, multisample: 0 });
  mirror.position.set(0, 1, -1.5);
  mirror.rotation.y = 0.3;
  host.keyLight.position.set(...light);
  // No object is behind the mirror.
  (host.scene.children[2] as Mesh).geometry = new PlaneGeometry(2.6, 2.6);
  host.scene.add(mirror);
  const smoke = await smokeIn(host, { ...values, 'style.outlines': 0 });
  host.renderer.render(host.scene, host.camera);
  await smoke.complete();
  const shown = draw(host);
  const halves = new Uint16Array(4 * WIDTH * HEIGHT);
  host.renderer.readRenderTargetPixels(mirror.getRenderTarget(), 0, 0, WIDTH, HEIGHT, halves);
  const camera = mirror.getReflectionCamera(host.camera) as PerspectiveCamera;
  camera.projectionMatrix.copy(host.camera.projectionMatrix);
  mirror.visible = false;
  const direct = draw({ ...host, camera });
  host.scene.remove(smoke);
  const empty = draw({ ...host, camera });
  dispose(smoke, host.renderer);
  const seen = seenIn(encoded(halves), direct, empty);
  const isBlack = (_: boolean, pixel: number) => shown.subarray(4 * pixel, 4 * pixel + 3).every((value) => value === 0);
  return {
    ...seen,
    black: Array<boolean>(WIDTH * HEIGHT)
      .fill(true)
      .filter(isBlack).length,
  };
}

function seenIn(shown: Pixels, direct: Pixels, empty: Pixels): Seen {
  return {
    difference: meanDifference(shown, direct),
    distinct: changedPixels(shown, direct, 25),
    smoke: changedPixels(direct, empty, 25),
  };
}

/** What a pass that draws the scene with one material shows of smoke, and the light of smoke under ambient occlusion. */
export async function byOcclusion(): Promise<{ normals: number; darkened: number; smoke: number }> {
  const host = plainHost(0);
  const { renderer, scene, camera } = host;
  const target = new WebGLRenderTarget(WIDTH, HEIGHT);
  const normals = () => {
    scene.overrideMaterial = new MeshNormalMaterial();
    renderer.setRenderTarget(target);
    renderer.render(scene, camera);
    scene.overrideMaterial = null;
    const pixels = new Uint8Array(4 * WIDTH * HEIGHT);
    renderer.readRenderTargetPixels(target, 0, 0, WIDTH, HEIGHT, pixels);
    renderer.setRenderTarget(null);
    return pixels;
  };
  const before = normals();
  const smoke = await smokeIn(host, { ...HANGING, 'style.shading': 0, 'style.outlines': 0, 'style.shadows': 0 });
  const isSmoke = smokePixels(host, smoke);
  const after = normals();
  const occluded = composed(host, 0, new GTAOPass(scene, camera, WIDTH, HEIGHT));
  occluded();
  await smoke.complete();
  const gaps = differences(draw(host), occluded());
  dispose(smoke, renderer);
  return {
    normals: changedPixels(before, after),
    darkened: gaps.filter((gap, pixel) => isSmoke[pixel] && gap > 25).length,
    smoke: isSmoke.filter(Boolean).length,
  };
}

/** Pixels that bloom changes, with white smoke and with a lamp that is brighter than white. */
export async function byBloom(): Promise<{ smoke: number; lamp: number }> {
  const host = plainHost(0);
  const smoke = await smokeIn(host, { ...HANGING, 'style.smokeColor': '#ffffff' });
  const plain = composed(host, 0);
  const size = new Vector2(WIDTH, HEIGHT);
  const blooming = composed(host, 0, new UnrealBloomPass(size, 1, 0.4, 1));
  plain();
  await smoke.complete();
  const bySmoke = changedPixels(plain(), blooming());
  const lamp = new Mesh(new SphereGeometry(0.1), new MeshBasicMaterial({ color: new Color(6, 4, 2) }));
  lamp.position.set(-0.5, 1, 1);
  host.scene.add(lamp);
  const byLamp = changedPixels(plain(), blooming());
  dispose(smoke, host.renderer);
  return { smoke: bySmoke, lamp: byLamp };
}

/** A face of a CubeCamera that shows smoke and its shadow, compared with a camera on the canvas. */
export async function byCubeCamera(): Promise<Seen> {
  const host = plainHost(0);
  host.renderer.setSize(HEIGHT, HEIGHT, false);
  const target = new WebGLCubeRenderTarget(HEIGHT, { type: HalfFloatType });
  const cubes = new CubeCamera(0.1, 50, target);
  cubes.position.set(0.2, 1, 1.9);
  host.scene.add(cubes);
  const smoke = await smokeIn(host);
  cubes.update(host.renderer, host.scene);
  await smoke.complete();
  cubes.update(host.renderer, host.scene);
  // The face towards -z.
  const face = 5;
  const halves = new Uint16Array(4 * HEIGHT * HEIGHT);
  host.renderer.readRenderTargetPixels(target, 0, 0, HEIGHT, HEIGHT, halves, face);
  const camera = new PerspectiveCamera(90, 1, 0.1, 50);
  camera.position.copy(cubes.position);
  const direct = draw({ ...host, camera });
  host.scene.remove(smoke);
  const empty = draw({ ...host, camera });
  dispose(smoke, host.renderer);
  return seenIn(upright(encoded(halves)), direct, empty);
}

/** A picture that was drawn upside down. */
function upright(pixels: Pixels): Pixels {
  const { length } = pixels;
  return pixels.map((_, at) => pixels[length - 4 - at + 2 * (at % 4)]);
}
