/** Lights of the host's scene on smoke, compared with three.js on toon materials. */
import {
  AmbientLight,
  Color,
  DataTexture,
  DirectionalLight,
  HemisphereLight,
  Mesh,
  MeshToonMaterial,
  NearestFilter,
  PointLight,
  RedFormat,
  SphereGeometry,
  SpotLight,
  Vector3,
  type Light,
  type Vector3Tuple,
} from 'three';
import type { Values } from '../../../../src/parameters/parameter.ts';
import type { KeyLight } from '../../../../src/three/keyLight.ts';
import { changedPixels, dispose, draw, emptyHost, HANGING, smokeIn, WIDTH, type Host, type Pixels } from '../scene.ts';

/** Linear reflectance of the material: C of Eq. 2. */
export const MATERIAL = [0.7, 0.45, 0.2];
/** N.L from which a tone applies, and its q. */
export const TONES = [
  { from: 0, q: 0 },
  { from: 0.3, q: 0.4 },
  { from: 0.66, q: 1 },
];
/** Colours of fewer pixels are those of smoothed edges. */
const FEW_PIXELS = 40;
const BACKGROUND = new Color('#ff00ff');
export const FAR = 1000;

/** The lights of a scene: the key light and the others. */
type Lights = readonly [key: KeyLight, ...others: Light[]];

export const sun = (color = '#ffffff', intensity = 3) => placed(new DirectionalLight(color, intensity));
const hidden = (light: DirectionalLight) => Object.assign(light, { visible: false });
export const white = new AmbientLight('#ffffff', 1);

export const LIGHTS: Readonly<Record<string, () => Lights>> = {
  reference: () => [sun(), white],
  'a red key light': () => [sun('#ff2010'), white],
  'half a key light': () => [sun('#ffffff', 1.5), white],
  'a strong key light': () => [sun('#ffffff', 3.5), new AmbientLight('#ffffff', 0.2)],
  'no key light': () => [sun('#ffffff', 0), white],
  'a hidden key light': () => [hidden(sun()), white],
  'ambient light of two colours': () => [sun(), new AmbientLight('#4060ff', 0.5), new AmbientLight('#ff8040', 0.3)],
  'no ambient light': () => [sun()],
  'a hemisphere light of one colour': () => [sun(), new HemisphereLight('#6080ff', '#6080ff', 0.8)],
  'a far lamp': () => [placed(new PointLight('#ffd0a0', 3 * FAR ** 2), FAR), white],
  'a lamp that does not decay': () => [placed(new PointLight('#ffffff', 3, 0, 0), FAR), white],
  'a lamp that ends': () => [placed(new PointLight('#ffffff', 2 * FAR ** 2, 2 * FAR), FAR), white],
  'the cone of a spot light': () => [placed(new SpotLight('#ffffff', 3, 0, 0.2, 0.5, 0), FAR), white],
  'beside the cone of a spot light': () => {
    const spot = placed(new SpotLight('#ffffff', 3, 0, 0.2, 0.5, 0), FAR);
    spot.target.position.set(600, 0, 0);
    spot.target.updateMatrixWorld();
    return [spot, white];
  },
};

/** The colours that many pixels have, from dark to light. */
export type Colors = number[][];

/** The colours of smoke and of a ball with a toon material under lights of a scene. */
export async function underLights(name: string): Promise<{ smoke: Colors; ball: Colors }> {
  const host = lightless();
  const lights = LIGHTS[name]();
  host.scene.add(...lights);
  const [keyLight] = lights;
  const smoke = await smokeIn({ ...host, keyLight: keyLight as DirectionalLight }, PLAIN, { light: 'scene' });
  const ofSmoke = colorsOf(draw(host));
  host.scene.remove(smoke);
  const ball = new Mesh(new SphereGeometry(0.7, 96, 64), toon());
  ball.position.set(0, 1.2, 0);
  host.scene.add(ball);
  const ofBall = colorsOf(draw(host));
  dispose(smoke, host.renderer);
  return { smoke: ofSmoke, ball: ofBall };
}

/** A scene of two puffs by a lamp. */
interface ByLamp {
  readonly lamp: () => PointLight | SpotLight;
  /** Position and scale of the smoke object. */
  readonly smoke?: readonly [place: Vector3Tuple, scale: number];
  readonly values?: Values;
}

/** Left and right. */
const PUFFS: readonly [Vector3Tuple, Vector3Tuple] = [
  [-0.9, 1, 0],
  [0.9, 1, 0],
];
const NEAR_LEFT: Vector3Tuple = [-1.2, 2, 1.2];

export const LAMPS: Readonly<Record<string, ByLamp>> = {
  'a lamp that decays': { lamp: () => movedTo(new PointLight('#ffffff', 8), NEAR_LEFT) },
  'simplified light': { lamp: () => movedTo(new PointLight('#ffffff', 8), NEAR_LEFT), values: { 'style.simplify': 1 } },
  'a lamp that ends': { lamp: () => movedTo(new PointLight('#ffd0a0', 8, 3.2, 1), NEAR_LEFT) },
  'a lamp that ends before the smoke object': {
    lamp: () => movedTo(new PointLight('#ffffff', 8, 3.2), NEAR_LEFT),
    smoke: [[9, 0, 0], 1],
  },
  'a spot light on one puff': { lamp: () => aimed(new SpotLight('#ffffff', 8, 0, 0.3), PUFFS[0]) },
  'a spot light whose edge is at the other puff': {
    lamp: () => aimed(new SpotLight('#ffffff', 20, 0, 0.9, 0.8), PUFFS[0]),
  },
  'smoke of half the size': {
    lamp: () => aimed(new SpotLight('#ffffff', 20, 4, 0.9, 0.8), PUFFS[0]),
    smoke: [[0.5, 0.2, 0], 0.5],
  },
};

function movedTo<Kind extends Light>(light: Kind, place: Vector3Tuple): Kind {
  light.position.set(...place);
  return light;
}

function aimed(light: SpotLight, target: Vector3Tuple): SpotLight {
  light.target.position.set(...target);
  light.target.updateMatrixWorld();
  return movedTo(light, NEAR_LEFT);
}

/** The colours of both puffs, from dark to light, and what each must have by the formulas of three.js. */
export async function byLamp(name: string): Promise<{ smoke: [Colors, Colors]; expected: [Colors, Colors] }> {
  const host = lightless();
  const { lamp, smoke: [place, scale] = [[0, 0, 0], 1], values } = LAMPS[name];
  const keyLight = lamp();
  host.scene.add(keyLight, white);
  const given: Values = { ...PLAIN, 'emission.rate': 0, 'emission.density': '0:1,1:1', ...values };
  const smoke = await smokeIn({ ...host, keyLight: keyLight as never }, given, { light: 'scene', space: 'local' });
  smoke.position.set(...place);
  smoke.rotation.y = scale === 1 ? 0 : 0.7;
  smoke.scale.setScalar(scale);
  smoke.step(1);
  for (const puff of PUFFS) {
    const position = new Vector3(...puff);
    void smoke.burst({
      position,
      count: 1,
      size: 0.5 / scale,
      sizeVariation: 0,
      speed: 0,
      shape: 'point',
      lifetime: 10,
    });
  }
  smoke.step(20);
  const pixels = draw(host);
  const halves = [0, 1].map((half) => colorsOf(halfOf(pixels, half)));
  const expected = PUFFS.map((puff) => {
    const colors = TONES.map(({ q }) => colorBy(keyLight, new Vector3(...puff), q));
    return colors.filter((color, tone) => tone === 0 || String(color) !== String(colors[tone - 1]));
  });
  dispose(smoke, host.renderer);
  return { smoke: halves as [Colors, Colors], expected: expected as [Colors, Colors] };
}

/** C (1 + I q) / pi under white ambient light of 1 and the light I that reaches a place, display-encoded. */
function colorBy(light: PointLight | SpotLight, place: Vector3, q: number): number[] {
  const { color, intensity, decay, distance, position } = light;
  const metres = position.distanceTo(place);
  const end = distance > 0 ? Math.max(0, 1 - (metres / distance) ** 4) ** 2 : 1;
  let reach = end / metres ** decay;
  if (light instanceof SpotLight) {
    const towards = light.target.position.clone().sub(position).normalize();
    const cosine = place.clone().sub(position).normalize().dot(towards);
    const [edge, full] = [light.angle, light.angle * (1 - light.penumbra)].map(Math.cos);
    const share = full > edge ? Math.min(1, Math.max(0, (cosine - edge) / (full - edge))) : Number(cosine > edge);
    reach *= share * share * (3 - 2 * share);
  }
  const shown = new Color(
    ...color.toArray().map((channel, index) => (MATERIAL[index] * (1 + intensity * reach * channel * q)) / Math.PI),
  );
  return shown
    .convertLinearToSRGB()
    .toArray()
    .map((channel) => Math.round(255 * Math.min(1, channel)));
}

function halfOf(pixels: Pixels, half: number): Pixels {
  const side = WIDTH / 2;
  return pixels.filter((_, index) => Math.floor(((index / 4) % WIDTH) / side) === half);
}

/**
 * Pixels that change while the lights of the host change: of smoke in the light of its style; of smoke whose key light was
 * replaced, compared with smoke that was created with that light; and casters that are drawn, with and without `castsShadow`
 * and for a key light of intensity 0.
 */
export async function changes() {
  const host = lightless();
  const [first, second] = [sun(), sun('#80a0ff', 2)];
  second.position.set(-4, 3, 2);
  host.scene.add(first, second, white);
  const keyed = (keyLight: DirectionalLight) => ({ ...host, keyLight });
  const styled = await smokeIn(keyed(first), HANGING);
  const before = draw(host);
  first.color.set('#ff0000');
  first.intensity = 0.5;
  const changed = changedPixels(before, draw(host));
  Object.assign(first, { intensity: 3, color: new Color('#ffffff') });
  host.scene.remove(styled);

  const lit = await smokeIn(keyed(first), HANGING, { light: 'scene' });
  const underFirst = draw(host);
  const casters = [lit.stats.castersDrawn];
  lit.castsShadow = false;
  draw(host);
  casters.push(lit.stats.castersDrawn);
  lit.castsShadow = true;
  first.intensity = 0;
  draw(host);
  casters.push(lit.stats.castersDrawn);
  first.intensity = 3;
  lit.keyLight = second;
  const replaced = draw(host);
  host.scene.remove(lit);
  const other = await smokeIn(keyed(second), HANGING, { light: 'scene' });
  const created = draw(host);
  const wrong = {
    changed,
    same: changedPixels(replaced, created),
    moved: changedPixels(underFirst, replaced) > 100,
    casters: casters.map((count) => count > 0),
  };
  dispose(styled, lit, other, host.renderer);
  return wrong;
}

export function lightless(): Host {
  const host = emptyHost();
  for (const light of host.scene.children.slice()) host.scene.remove(light);
  host.scene.background = BACKGROUND;
  return host;
}

export function placed<Kind extends Light>(light: Kind, metres = 5): Kind {
  light.position.set(2, 5, 3).setLength(metres);
  return light;
}

function toon(): MeshToonMaterial {
  const red = Uint8Array.from({ length: 256 }, (_, texel) => {
    const facing = (2 * (texel + 0.5)) / 256 - 1;
    return Math.round(255 * TONES.findLast(({ from }) => from === 0 || facing >= from)!.q);
  });
  const gradientMap = new DataTexture(red, 256, 1, RedFormat);
  gradientMap.minFilter = gradientMap.magFilter = NearestFilter;
  gradientMap.needsUpdate = true;
  return new MeshToonMaterial({ color: new Color().fromArray(MATERIAL), gradientMap });
}

export const PLAIN: Values = {
  ...HANGING,
  'style.ramp': TONES.map(
    ({ from, q }) => `${from}:${colorOf(MATERIAL.map((c) => (c * (1 + 3 * q)) / Math.PI))}`,
  ).join(),
  'style.outlines': 0,
  'style.shadows': 0,
  'style.simplify': 0,
};

function colorOf(linear: readonly number[]): string {
  return new Color().fromArray(linear).getHexString();
}

export function colorsOf(pixels: Pixels): Colors {
  const counts = new Map<string, number>();
  for (let at = 0; at < pixels.length; at += 4) {
    const color = String(pixels.subarray(at, at + 3));
    counts.set(color, (counts.get(color) ?? 0) + 1);
  }
  const own = [...counts].filter(([color, count]) => count >= FEW_PIXELS && color !== '255,0,255');
  const colors = own.map(([color]) => color.split(',').map(Number));
  const sum = (color: readonly number[]) => color.reduce((all, channel) => all + channel, 0);
  // Puffs at slightly different distances from a lamp differ by rounding.
  const isNew = (color: readonly number[], before?: readonly number[]) =>
    !before || color.some((channel, index) => Math.abs(channel - before[index]) > 1);
  return colors.toSorted((a, b) => sum(a) - sum(b)).filter((color, tone, all) => isNew(color, all[tone - 1]));
}
