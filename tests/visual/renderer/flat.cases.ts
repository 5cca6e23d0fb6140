/** Pictures of the fallback without fragment depth, compared with the regular renderer. */
import { OrthographicCamera, PerspectiveCamera, Vector3, type Camera } from 'three';
import { createDevice } from '../../../src/renderer/gpu/device.ts';
import type { Values } from '../../../src/parameters/parameter.ts';
import { defaultPreset, presetValues } from '../../../src/parameters/presets.ts';
import { createStage } from '../../../src/stage/stage.ts';
import { PLAIN_STYLE, Lab, type LabPicture, type LabPuff, type LabScene } from '../lab.ts';
import { random } from '../random.ts';
import { box, ground } from '../solids.ts';
import { PLAIN_LOOK } from '../../support/plainLook.ts';

const [WIDTH, HEIGHT] = [320, 240];

type Triple = [number, number, number];

const SUN = new Vector3(-0.5, 0.8, 0.4).normalize().toArray();

/** Whether this machine passes the self test, and whether a device can simulate a failure. */
export function selfTest(): { passes: boolean; notified: boolean; error: number } {
  const [device, notified] = [{}, { failsSelfTest: true }].map((options) =>
    createDevice(new OffscreenCanvas(1, 1), options),
  );
  const [passes, kept] = [device.writesDepth, notified.writesDepth];
  const error = device.renderer.getContext().getError();
  const report = { passes, notified: kept, error };
  for (const each of [device, notified]) each.dispose();
  return report;
}

/** The self test with `gl_FragDepth` disabled, as with some drivers. */
export function selfTestWithoutWriting(): boolean {
  const { shaderSource } = WebGL2RenderingContext.prototype;
  WebGL2RenderingContext.prototype.shaderSource = function (shader, source) {
    shaderSource.call(this, shader, source.replaceAll(/gl_FragDepth = .*;/g, ''));
  };
  const device = createDevice(new OffscreenCanvas(1, 1));
  const { writesDepth } = device;
  WebGL2RenderingContext.prototype.shaderSource = shaderSource;
  device.dispose();
  return writesDepth;
}

/** What a device says of the self test while its context is lost before the test has run. */
export function selfTestWithoutContext(): boolean {
  const device = createDevice(new OffscreenCanvas(1, 1));
  device.renderer.forceContextLoss();
  const { writesDepth } = device;
  device.dispose();
  return writesDepth;
}

function looking(camera: Camera, from: Triple, at: Triple): Camera {
  camera.position.set(...from);
  camera.lookAt(...at);
  camera.updateMatrixWorld();
  return camera;
}

const perspective = () => new PerspectiveCamera(45, WIDTH / HEIGHT, 0.1, 100);

/** Camera and light of the scene. */
const VIEWS: Readonly<Record<string, () => Partial<LabScene>>> = {
  ordinary: () => ({ camera: looking(perspective(), [0.5, 1.6, 5], [0, -0.4, 0]) }),
  lamp: () => ({ camera: looking(perspective(), [0.5, 1.6, 5], [0, -0.4, 0]), lamp: [-0.8, 2.6, 0.5] }),
  orthographic: () => ({
    camera: looking(new OrthographicCamera(-3, 3, 2.25, -2.25, 0.1, 100), [2, 2.5, 5], [0, -0.4, 0]),
  }),
};

/** A small cloud above a ground with a box. */
function cloud(count: number): LabPuff[] {
  const next = random(31);
  return Array.from({ length: count }, () => ({
    place: [1.4 * next() - 0.7, 0.5 * next() + 0.35, 1.2 * next() - 0.6],
    radius: 0.22 + 0.16 * next(),
    roll: next() * 2 * Math.PI,
    variation: Math.floor(next() * 4),
    seed: Math.floor(next() * 256),
  }));
}

function sceneOf(puffs: readonly LabPuff[], extra: Partial<LabScene>): LabScene {
  const mesh = box([1.1, -0.6, 0.3], [0.25, 0.4, 0.25]);
  return {
    width: WIDTH,
    height: HEIGHT,
    puffs,
    surfaces: [ground(-1, 3), { name: 'box', mesh, color: [200, 60, 60], casts: true, inked: false }],
    towardsLight: SUN,
    readCounts: true,
    ...extra,
  };
}

/** Agreement of the two methods about shadow on the ground, ink and smoke. */
export interface Agreement {
  /** Pixels of ground and box in the nailboard shadow, in the flat shadow, and in both. */
  shadow: number;
  flatShadow: number;
  shadowAgreed: number;
  ink: number;
  flatInk: number;
  smoke: number;
  smokeAgreed: number;
  error: number;
}

/** The ground and the box below a cloud, drawn with both methods. */
export function agreement(view: string): Agreement {
  const scene = sceneOf(cloud(40), VIEWS[view]());
  const nailboards = draw(scene, false);
  const flat = draw(scene, true);
  const report: Agreement = { ...EMPTY, error: flat.error };
  for (let pixel = 0; pixel < WIDTH * HEIGHT; ++pixel) {
    const kinds = [nailboards, flat].map(({ picture }) => kindOf(picture, pixel));
    const counts = [nailboards, flat].map(({ picture }) => picture.counts[pixel]);
    if (kinds[0] === 'ink') report.ink += 1;
    if (kinds[1] === 'ink') report.flatInk += 1;
    if (kinds.includes('smoke')) report.smoke += 1;
    if (kinds.every((kind) => kind === 'smoke')) report.smokeAgreed += 1;
    if (kinds.some((kind) => kind !== 'other')) continue;
    if (counts[0] > 0) report.shadow += 1;
    if (counts[1] > 0) report.flatShadow += 1;
    if (counts.every((count) => count > 0)) report.shadowAgreed += 1;
  }
  return report;
}

const EMPTY: Omit<Agreement, 'error'> = {
  shadow: 0,
  flatShadow: 0,
  shadowAgreed: 0,
  ink: 0,
  flatInk: 0,
  smoke: 0,
  smokeAgreed: 0,
};

function draw(scene: LabScene, failsSelfTest: boolean): { picture: LabPicture; error: number } {
  const lab = new Lab({ ...scene, failsSelfTest });
  const picture = lab.draw(scene);
  const error = lab.error;
  lab.dispose();
  return { picture, error };
}

function kindOf({ pixels }: LabPicture, pixel: number): 'ink' | 'smoke' | 'other' {
  const [red, green, blue] = pixels.subarray(4 * pixel, 4 * pixel + 3);
  const { inkColor } = PLAIN_STYLE;
  if (red === inkColor[0] && green === inkColor[1] && blue === inkColor[2]) return 'ink';
  // Ground and box are redder than every tone of the smoke.
  return red > 0 && red < blue + 40 ? 'smoke' : 'other';
}

/** Lit pixels of a lone flat puff, and those that its own shadow volume masks. */
export function flatSelfMasked(trials: number): { lit: number; masked: number } {
  const next = random(8);
  const scene = { width: WIDTH, height: HEIGHT, puffs: [], capacity: 1, failsSelfTest: true };
  const lab = new Lab(scene);
  const result = { lit: 0, masked: 0 };
  for (let trial = 0; trial < trials; ++trial) {
    const direction = [next() - 0.5, next() - 0.5, next() - 0.5] as const;
    const puff: LabPuff = {
      place: [1.5 * next() - 0.75, next() - 0.5, next() - 0.5],
      radius: 0.6,
      roll: 6 * next(),
      variation: trial % 4,
      seed: Math.floor(256 * next()),
    };
    const [free, masked] = [false, true].map((shadows) =>
      lab.draw({ ...scene, puffs: [puff], towardsLight: direction, style: { shadows } }),
    );
    for (let at = 0; at < free.pixels.length; at += 4) {
      if (free.pixels[at] !== PLAIN_STYLE.smokeColor[0]) continue;
      result.lit += 1;
      if (masked.pixels[at] !== free.pixels[at]) result.masked += 1;
    }
  }
  lab.dispose();
  return result;
}

/** Pixels in the common shadow of many coincident casters, and those of them that are lit. */
export function coincident(count: number): { shadowed: number; lit: number } {
  const casters = Array.from({ length: count }, (): LabPuff => ({ place: [0, 0, 0], radius: 0.5 }));
  const countsOf = (some: readonly LabPuff[]) => {
    const scene = sceneOf([], { ...VIEWS.ordinary(), casters: some, surfaces: [ground(-1, 3)] });
    return draw(scene, true).picture.counts;
  };
  const [one, all] = [countsOf(casters.slice(0, 1)), countsOf(casters)];
  const shadowed = one.filter((value) => value > 0).length;
  return { shadowed, lit: one.filter((value, pixel) => value > 0 && all[pixel] === 0).length };
}

/** A stage that fails the self test: its `writesDepth`, and pixels of smoke, ink and shadow in its picture. */
export async function flatStage(): Promise<{ writesDepth: boolean; ink: number; smoke: number; shadowed: number }> {
  const pictures = await Promise.all(
    ([1, 0] as const).map(async (shadows) => {
      const values: Values = {
        ...presetValues(defaultPreset),
        ...PLAIN_LOOK,
        'style.shadows': shadows,
        'simulation.maxParticles': 800,
      };
      const canvas = new OffscreenCanvas(WIDTH, HEIGHT);
      const stage = await createStage(canvas, { values, width: WIDTH, height: HEIGHT, failsSelfTest: true });
      stage.step(180);
      const { writesDepth } = stage.stats;
      const pixels = await pixelsOf(await stage.picture());
      stage.dispose();
      return { writesDepth, pixels };
    }),
  );
  const [shaded, free] = pictures.map(({ pixels }) => pixels);
  const count = (color: string) => shaded.filter((pixel) => pixel.toString(16) === `ff${color}`).length;
  return {
    writesDepth: pictures[0].writesDepth,
    // Byte order: alpha, blue, green, red.
    ink: count('20171d'),
    smoke: count('e2eff6'),
    shadowed: shaded.filter((pixel, index) => pixel !== free[index]).length,
  };
}

async function pixelsOf(picture: Blob): Promise<Uint32Array> {
  const bitmap = await createImageBitmap(picture);
  const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d')!;
  context.drawImage(bitmap, 0, 0);
  return new Uint32Array(context.getImageData(0, 0, bitmap.width, bitmap.height).data.buffer);
}
