/** Values that `get` gives are values that `set` takes. */
import type { State } from '../../../src/parameters/codec.ts';
import type { Values } from '../../../src/parameters/parameter.ts';
import { openHere } from '../../../src/stage/remote/openHere.ts';
import { openStage } from '../../../src/stage/remote/openStage.ts';
import type { RemoteStage } from '../../../src/stage/remote/contract.ts';
import { CartoonSmoke } from '../../../src/three/cartoonSmoke.ts';
import { emptyHost, type Host } from './scene.ts';

const STEPS = 3;

/** What is not the same after `set(get())`, by state. */
type Faults = Record<string, string>;

interface Subject {
  get(): Values | Promise<Values>;
  set(values: Values): void | Promise<void>;
  hash(): string | Promise<string>;
}

async function faultOf(subject: Subject): Promise<string> {
  try {
    const [values, hash] = [await subject.get(), await subject.hash()];
    await subject.set(values);
    if ((await subject.hash()) !== hash) return 'another hash';
    return JSON.stringify(await subject.get()) === JSON.stringify(values) ? '' : 'other values';
  } catch (error) {
    return String(error);
  }
}

async function faults(states: readonly State[], check: (values: Values) => Promise<string>): Promise<Faults> {
  const found: Faults = {};
  for (const [index, { preset, values }] of states.entries()) {
    const fault = await check(values).catch(String);
    if (fault) found[`${index} ${preset}`] = fault;
  }
  return found;
}

/** Smoke that starts with the values of a state, and smoke that they are set on, as its own `get` gives them. */
export async function ofSmoke(states: readonly State[]): Promise<Faults> {
  const { renderer, keyLight }: Host = emptyHost();
  const other = await CartoonSmoke.create({ renderer, keyLight });
  const found = await faults(states, async (values) => {
    const smoke = await CartoonSmoke.create({ renderer, keyLight, values });
    smoke.step(STEPS);
    const fault = await faultOf(smoke);
    other.set(smoke.get());
    // The code of its first flow may still be on the way.
    await other.complete();
    other.step(1);
    smoke.dispose();
    return fault || faultOf(other);
  });
  renderer.dispose();
  return found;
}

/** Stages of this thread and of a worker. */
export async function ofStage(states: readonly State[], thread: 'main' | 'worker'): Promise<Faults> {
  const canvas = document.createElement('canvas');
  document.body.append(canvas);
  const options = { width: 40, height: 30 };
  const stage: RemoteStage =
    thread === 'main' ? await openHere(canvas, options) : await openStage(() => canvas, { ...options, thread });
  const found = await faults(states, async (values) => {
    await stage.enter(values);
    await stage.step(STEPS);
    return faultOf(stage);
  });
  await stage.dispose();
  canvas.remove();
  return found;
}

/** What the host has of the light, too, which multiplies these. */
const OF_LIGHT: Values = {
  'light.color': '#ff8040',
  'light.intensity': 0.5,
  'light.ambientColor': '#4060ff',
  'light.ambient': 2,
};

/** What `set` says about what the host's scene determines, and which of these `create` and a link took. */
export async function ofHost(link: string) {
  const { renderer, keyLight } = emptyHost();
  const given = {
    scene: 'train',
    'light.azimuth': 20,
    'light.decay': 2,
    'camera.distance': 3,
    'style.renderer': 'selle',
    'style.backdrop': '0:112233,1:445566',
    seed: 7,
    'simulation.maxParticles': 900,
  } as const;
  const smokes = await Promise.all([
    CartoonSmoke.create({ renderer, keyLight, values: { ...given, ...OF_LIGHT, 'puff.size': 2 } }),
    CartoonSmoke.create({ renderer, keyLight, preset: link as '#' }),
  ]);
  const plain = await CartoonSmoke.create({ renderer, keyLight, values: { seed: 7, 'puff.size': 2 } });
  const errors = Object.entries(given).map(([key, value]) => {
    try {
      plain.set({ [key]: value });
      return `${key} is taken`;
    } catch (error) {
      return String(error);
    }
  });
  for (const smoke of [...smokes, plain]) smoke.step(40);
  const kept = Object.keys(given).filter((key) => smokes.some((smoke) => key in smoke.get()));
  const links = [
    'lampp',
    '#v=1&preset=lampp',
    '#v=1&emission.rates=1',
    '#v=1&emission.rate=a',
    '#z=damaged',
    3 as never,
  ];
  const bad = await Promise.all(
    links.map((preset) => CartoonSmoke.create({ renderer, keyLight, preset: preset as '#' }).then(String, String)),
  );
  plain.set(OF_LIGHT);
  const light = [smokes[0], plain].map((smoke) =>
    Object.entries(OF_LIGHT).every(([key, value]) => smoke.get()[key as keyof Values] === value),
  );
  const hashes = [...smokes, plain].map((smoke) => smoke.hash());
  const sizes = smokes.map((smoke) => smoke.get()['puff.size']);
  for (const smoke of [...smokes, plain]) smoke.dispose();
  renderer.dispose();
  return { errors, kept, bad, hashes, sizes, light };
}
