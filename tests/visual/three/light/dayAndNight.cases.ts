/** Smoke on a floor with a ball in the light of its scene, on the canvas and by a composer with tone mapping. */
import {
  AmbientLight,
  Color,
  DirectionalLight,
  HalfFloatType,
  Mesh,
  MeshStandardMaterial,
  PlaneGeometry,
  PointLight,
  SphereGeometry,
  SpotLight,
  WebGLRenderTarget,
  type Light,
  type ToneMapping,
  type Vector3Tuple,
} from 'three';
import { EffectComposer } from 'three/examples/jsm/postprocessing/EffectComposer.js';
import { OutputPass } from 'three/examples/jsm/postprocessing/OutputPass.js';
import { RenderPass } from 'three/examples/jsm/postprocessing/RenderPass.js';
import type { Values } from '../../../../src/parameters/parameter.ts';
import type { KeyLight } from '../../../../src/three/keyLight.ts';
import {
  differences,
  dispose,
  draw,
  emptyHost,
  HANGING,
  HEIGHT,
  makeRenderer,
  readCanvas,
  smokeIn,
  WIDTH,
  type Pixels,
} from '../scene.ts';

/** The key light, the ambient light, and further lights. */
type Lights = readonly [key: KeyLight, ambient: AmbientLight, ...others: Light[]];

const ABOVE: Vector3Tuple = [2, 5, 3];
const LOW: Vector3Tuple = [-5, 1.6, 2];

function at<Kind extends Light>(light: Kind, place: Vector3Tuple): Kind {
  light.position.set(...place);
  return light;
}

function spot(target: Vector3Tuple): SpotLight {
  const light = at(new SpotLight('#fff0c8', 60, 0, 0.32, 0.4), [1.5, 4.2, 2.5]);
  light.target.position.set(...target);
  light.target.updateMatrixWorld();
  return light;
}

const dim = () => new AmbientLight('#5060a8', 0.35);

export const SCENES: Readonly<Record<string, { sky: string; lights: () => Lights }>> = {
  noon: {
    sky: '#8cc4ea',
    lights: () => [at(new DirectionalLight('#ffffff', 3), ABOVE), new AmbientLight('#ffffff', 1)],
  },
  dusk: {
    sky: '#c88a94',
    lights: () => [at(new DirectionalLight('#ff9048', 2.4), LOW), new AmbientLight('#8478b8', 0.6)],
  },
  night: { sky: '#151a38', lights: () => [at(new DirectionalLight('#90a8ff', 0.5), ABOVE), dim()] },
  'a red lamp': { sky: '#151a38', lights: () => [at(new PointLight('#ff2818', 14), [1.7, 1.9, 1.4]), dim()] },
  'a blue and an orange lamp': {
    sky: '#151a38',
    lights: () => [
      at(new DirectionalLight('#ffffff', 0), ABOVE),
      dim(),
      at(new PointLight('#4070ff', 12), [-1.8, 1.4, 1]),
      at(new PointLight('#ff8020', 12), [1.8, 1.2, 1]),
    ],
  },
  'in the cone of a spot light': { sky: '#151a38', lights: () => [spot([0, 1.2, 0]), dim()] },
  'beside the cone of a spot light': { sky: '#151a38', lights: () => [spot([3, 0, -2]), dim()] },
};

/** Behind smoke whose pixels are counted. */
const MASK = '#ff0000';

/** Billows of round puffs with lines and simplified light. */
const LOOK: Values = {
  ...HANGING,
  'emitters.0.radius': 0.55,
  'emitters.0.size': 0.62,
  'emitters.0.sizeVariation': 0.4,
  'emitters.0.position.y': 1.1,
  'style.simplify': 2,
  'style.form': 0.2,
  'style.outlineWidth': 1.5,
};

interface Shot {
  readonly canvas: Pixels;
  readonly composed: Pixels;
  /** Pixels of smoke. */
  readonly isSmoke: readonly boolean[];
}

/** @param size width and height in pixels */
export async function shoot(
  name: string,
  size: [width: number, height: number],
  toneMapping: ToneMapping,
): Promise<Shot> {
  const host = emptyHost(makeRenderer({}, size, toneMapping));
  const { renderer, scene, camera } = host;
  const { sky, lights } = SCENES[name];
  scene.remove(...scene.children);
  const [keyLight, ...others] = lights();
  const floor = new Mesh(new PlaneGeometry(9, 9), new MeshStandardMaterial({ color: '#b09878' }));
  floor.rotation.x = -Math.PI / 2;
  const ball = new Mesh(new SphereGeometry(0.34, 48, 32), new MeshStandardMaterial({ color: '#d8d0c8' }));
  ball.position.set(1.25, 0.34, 0.7);
  scene.add(keyLight, ...others);
  camera.position.set(0.4, 1.9, 5);
  camera.lookAt(0, 0.9, 0);
  const smoke = await smokeIn({ ...host, keyLight: keyLight as DirectionalLight }, LOOK, { light: 'scene' });
  await smoke.complete();
  const [alone, beforeBlue] = [MASK, '#0000ff'].map((background) => {
    scene.background = new Color(background);
    return draw(host).slice();
  });
  const isSmoke = differences(alone, beforeBlue).map((difference) => difference === 0);
  scene.background = new Color(sky);
  scene.add(floor, ball);
  const canvas = draw(host).slice();
  const composer = new EffectComposer(renderer, new WebGLRenderTarget(...size, { type: HalfFloatType }));
  for (const pass of [new RenderPass(scene, camera), new OutputPass()]) composer.addPass(pass);
  composer.render(0);
  const composed = readCanvas(renderer).slice();
  composer.dispose();
  dispose(smoke, renderer);
  return { canvas, composed, isSmoke };
}

/** Of smoke in a picture: the mean colour in each half. */
interface Halves {
  left: number[];
  right: number[];
}

/** Smoke on the canvas and by the composer, its pixels, and how far apart the two are inside of regions of one colour. */
export async function measure(name: string, toneMapping: ToneMapping) {
  const { canvas, composed, isSmoke } = await shoot(name, [WIDTH, HEIGHT], toneMapping);
  const gaps = differences(canvas, composed);
  const inside = gaps.filter(
    (_, pixel) =>
      isSmoke[pixel] &&
      [1, -1, WIDTH, -WIDTH].every((step) => isSmoke[pixel + step] && isAlike(canvas, pixel, pixel + step)),
  );
  return {
    canvas: halvesOf(canvas, isSmoke),
    composed: halvesOf(composed, isSmoke),
    smoke: inside.length,
    apart: Math.max(...inside),
  };
}

function halvesOf(pixels: Pixels, isSmoke: readonly boolean[]): Halves {
  const sums = [0, 1].map(() => [0, 0, 0, 0]);
  isSmoke.forEach((isIt, pixel) => {
    if (!isIt) return;
    const sum = sums[Number(pixel % WIDTH >= WIDTH / 2)];
    for (let channel = 0; channel < 3; ++channel) sum[channel] += pixels[4 * pixel + channel];
    ++sum[3];
  });
  const [left, right] = sums.map(([red, green, blue, count]) => [red, green, blue].map((sum) => sum / count));
  return { left, right };
}

function isAlike(pixels: Pixels, one: number, other: number): boolean {
  return [0, 1, 2].every((channel) => Math.abs(pixels[4 * one + channel] - pixels[4 * other + channel]) <= 3);
}
