/** Lights of the host's scene besides the key light, compared with Eq. 2 computed by hand. */
import { Color, DirectionalLight, PointLight, SpotLight, Vector3, type Light, type Vector3Tuple } from 'three';
import type { Values } from '../../../../src/parameters/parameter.ts';
import { changedPixels, dispose, draw, smokeIn, type Host } from '../scene.ts';
import { colorsOf, FAR, lightless, MATERIAL, PLAIN, sun, TONES, white, type Colors } from './light.cases.ts';

interface Lit {
  readonly lights: () => Light[];
  /** Irradiance that each gives, as a factor on its colour; 0 for lights that are off. */
  readonly strengths: readonly number[];
  readonly key?: DirectionalLight | PointLight;
  readonly values?: Values;
  /** Whether the smoke object is scaled and turned. */
  readonly placed?: boolean;
}

const MOON = '#3050ff';
const LANTERN = '#ff6010';
const FROM_LEFT: Vector3Tuple = [-3, 1, 1];
const FROM_RIGHT: Vector3Tuple = [3, -1, 2];
const FROM_BELOW: Vector3Tuple = [-1, -1, 2];
const FROM_BEHIND: Vector3Tuple = [0.3, 2, -1];

function at<Kind extends Light>(light: Kind, towards: Vector3Tuple, metres = FAR): Kind {
  light.position.set(...towards).setLength(metres);
  light.updateMatrixWorld();
  return light;
}

const moon = () => at(new DirectionalLight(MOON, 2), FROM_LEFT);
const lantern = () => at(new PointLight(LANTERN, 2.5 * FAR ** 2), FROM_RIGHT);

export const CASES: Readonly<Record<string, Lit>> = {
  'a blue moon': { lights: () => [moon()], strengths: [2] },
  'a blue moon and an orange lantern': { lights: () => [moon(), lantern()], strengths: [2, 2.5] },
  'three lights': {
    lights: () => [moon(), lantern(), at(new SpotLight('#30ff40', 1, 0, 0.2, 0.5, 0), FROM_BEHIND)],
    strengths: [2, 2.5, 1],
  },
  'simplified light': { lights: () => [moon(), lantern()], strengths: [2, 2.5], values: { 'style.simplify': 1 } },
  'light that follows the whole form': {
    lights: () => [moon(), lantern()],
    strengths: [2, 2.5],
    values: { 'style.simplify': 1, 'style.form': 0.5 },
  },
  billboards: { lights: () => [moon(), lantern()], strengths: [2, 2.5], values: { 'puff.form': 'billboards' } },
  'stretched puffs': { lights: () => [moon(), lantern()], strengths: [2, 2.5], values: { 'puff.stretch': 2 } },
  'a key light that decays': {
    lights: () => [moon()],
    strengths: [2],
    key: at(new PointLight('#ffffff', 3 * FAR ** 2), [2, 5, 3]),
  },
  'smoke that is scaled and turned': { lights: () => [moon(), lantern()], strengths: [2, 2.5], placed: true },
  'a light that is hidden': { lights: () => [Object.assign(moon(), { visible: false })], strengths: [0] },
  'a light of intensity 0': { lights: () => [Object.assign(moon(), { intensity: 0 })], strengths: [0] },
  'beside the cone of a spot light': {
    lights: () => {
      const spot = at(new SpotLight(LANTERN, 3, 0, 0.2, 0, 0), FROM_LEFT);
      spot.target.position.set(0, 900, 0);
      spot.target.updateMatrixWorld();
      return [spot];
    },
    strengths: [0],
  },
};

/** The colours that many pixels of smoke have, and those of each tone in each set of lights by Eq. 2, with the set. */
export async function underLights(
  name: string,
): Promise<{ found: Colors; expected: { color: number[]; set: number }[] }> {
  const { lights, strengths, key = sun('#ffffff', 0.6), values, placed = false } = CASES[name];
  const host = lightless();
  const all = lights();
  host.scene.add(key, white, ...all);
  const smoke = await smokeIn(keyed(host, key), { ...PLAIN, ...values }, { light: 'scene', space: 'local' });
  if (placed) {
    smoke.scale.setScalar(1.6);
    smoke.rotation.y = 0.7;
    smoke.position.y = -1;
  }
  const found = colorsOf(draw(host));
  dispose(smoke, host.renderer);
  const direct = key instanceof PointLight ? 3 : key.intensity;
  const expected = TONES.flatMap(({ q }) =>
    Array.from({ length: 1 << all.length }, (_, set) => {
      const sum = new Color(1, 1, 1).addScalar(direct * q);
      all.forEach(({ color }, index) => {
        // Lights have the q of full light.
        if (set & (1 << index)) sum.add(color.clone().multiplyScalar(strengths[index]));
      });
      return { color: displayed(sum), set };
    }),
  );
  return { found, expected };
}

/** C light / pi, display-encoded. */
function displayed(light: Color): number[] {
  const shown = light.toArray().map((channel, index) => Math.min(1, (MATERIAL[index] * channel) / Math.PI));
  const encoded = new Color().fromArray(shown).convertLinearToSRGB();
  return encoded.toArray().map((channel) => Math.round(255 * channel));
}

function keyed(host: Host, keyLight: DirectionalLight | PointLight): Host {
  return { ...host, keyLight: keyLight as DirectionalLight };
}

/** How much the picture changes in a step at most, while a fourth light becomes the third in 40 steps, and in all. */
export async function whileLightsSwap(values: Values): Promise<{ step: number; all: number }> {
  const host = lightless();
  const key = sun('#ffffff', 0.6);
  const lights = [FROM_LEFT, FROM_RIGHT, FROM_BEHIND, FROM_BELOW].map((towards, index) =>
    at(new DirectionalLight([MOON, LANTERN, '#30ff40', '#ff30c0'][index], 2), towards),
  );
  host.scene.add(key, white, ...lights);
  const smoke = await smokeIn(keyed(host, key), { ...PLAIN, ...values }, { light: 'scene' });
  const pictures = Array.from({ length: 41 }, (_, step) => {
    lights[2].intensity = 1 - 0.0125 * step;
    lights[3].intensity = 0.5 + 0.0125 * step;
    return draw(host).slice();
  });
  dispose(smoke, host.renderer);
  const change = (one: Uint8Array, other: Uint8Array) =>
    one.reduce((sum, byte, index) => sum + Math.abs(byte - other[index]), 0);
  const steps = pictures.slice(1).map((picture, index) => change(pictures[index], picture));
  return { step: Math.max(...steps), all: change(pictures[0], pictures[40]) };
}

/** Pixels of smoke in the light of its style that a light changes, and the most that a faint light changes in a scene's light. */
export async function ofFaintLights(): Promise<{ styled: number; most: number }> {
  const host = lightless();
  const key = sun();
  host.scene.add(key, white);
  const smoke = await smokeIn(keyed(host, key), PLAIN);
  const before = draw(host).slice();
  const light = moon();
  host.scene.add(light);
  const styled = changedPixels(before, draw(host));
  host.scene.remove(smoke, light);
  const lit = await smokeIn(keyed(host, key), { ...PLAIN, 'style.simplify': 1 }, { light: 'scene' });
  const alone = draw(host).slice();
  light.intensity = 1e-5;
  host.scene.add(light);
  const most = draw(host).reduce((greatest, byte, index) => Math.max(greatest, Math.abs(byte - alone[index])), 0);
  dispose(smoke, lit, host.renderer);
  return { styled, most };
}

/** Mean colours of the left and the right half of smoke between a blue lamp on the left and an orange one on the right. */
export async function betweenLamps(values: Values): Promise<[left: Vector3Tuple, right: Vector3Tuple]> {
  const host = lightless();
  const [blue, orange] = [new PointLight(MOON, 14), new PointLight(LANTERN, 14)];
  blue.position.set(-1.8, 1.4, 0.8);
  orange.position.set(1.8, 1.2, 0.8);
  const key = sun('#ffffff', 0);
  host.scene.add(key, blue, orange);
  const smoke = await smokeIn(keyed(host, key), { ...PLAIN, ...values }, { light: 'scene' });
  const pixels = draw(host);
  const halves = [new Vector3(), new Vector3()];
  const width = host.renderer.domElement.width;
  for (let pixel = 0; pixel < pixels.length / 4; ++pixel) {
    const [red, green, bluest] = pixels.subarray(4 * pixel, 4 * pixel + 3);
    if (red === 255 && green === 0 && bluest === 255) continue;
    halves[Number(pixel % width >= width / 2)].add(new Vector3(red, green, bluest));
  }
  dispose(smoke, host.renderer);
  return [halves[0].toArray(), halves[1].toArray()];
}
