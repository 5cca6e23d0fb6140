/** Six emitters with looks of their own, on a stage. Runs inside a page. */
import type { Values } from '../../../src/parameters/parameter.ts';
import { defaults } from '../../../src/parameters/values.ts';
import type { EmitterLook } from '../../../src/simulator/emitterOptions.ts';
import { createStage, type Stage } from '../../../src/stage/stage.ts';
import { PLAIN_LOOK } from '../../support/plainLook.ts';

const [WIDTH, HEIGHT] = [720, 300];
const EMITTERS = 6;
/** Metres between emitters. */
const SPACING = 1;

/** Colours by age, heat and tone, lifetimes, sizes, densities, ways to dissolve, factors of forces and ink. */
export const LOOKS: readonly EmitterLook[] = [
  { colors: '0:5a1020,.45:e0403a', lifetime: 1.2, inkWeight: 2.5 },
  { colors: '0:6a4a10,.45:ffd24a', dissolve: 'tear', drag: 3 },
  { ageColors: '0:d0ffb0,.35:58b050,.7:205838', growthTime: 0.2, densityCurve: '0:1,.7:1,1:0' },
  { colors: '0:103a5a,.3:2f8fd0,.66:bfe8ff', dissolve: 'erode', buoyancy: 1.8 },
  { heatColors: '0:3a3050,.5:8040c0,.9:ffb0ff', gravity: 3, sizeCurve: '0:.3,.5:1,1:.6' },
  { colors: '0:202024,.5:50505a', inkWeight: 0, lifetime: 4 },
];

const BASE: Values = {
  ...defaults(),
  ...PLAIN_LOOK,
  scene: 'air',
  seed: 7,
  'emission.rate': 120,
  'emission.lifetime': 2.5,
  'emission.growthTime': 0.6,
  'forces.turbulence': 0.5,
  'gravity.acceleration': 0.4,
  'puff.turn': 0.5,
  'style.smokeColor': '#f6efe2',
  'style.tones': 2,
  'style.shadows': 1,
  'style.outlineWidth': 1.6,
  'simulation.maxParticles': 800,
  'camera.azimuth': 0,
  'camera.elevation': 5,
  'camera.distance': 8.5,
  'camera.target.x': 0,
  'camera.target.y': 1.3,
  'camera.target.z': 0,
};

function placeOf(emitter: number): number {
  return SPACING * (emitter - (EMITTERS - 1) / 2);
}

/** Emitters in a row. @param looks of each of them */
function valuesWith(looks: readonly EmitterLook[]): Values {
  const each = Array.from({ length: EMITTERS }, (_, emitter) => ({
    shape: 'disc',
    radius: 0.08,
    'position.x': placeOf(emitter),
    'position.y': 0.3,
    speed: 0.9,
    size: 0.2,
    share: 1,
    ...Object.fromEntries(Object.entries(looks[emitter] ?? {}).map(([name, value]) => [`look.${name}`, value])),
  }));
  const values = each.flatMap((fields, emitter) =>
    Object.entries(fields).map(([name, value]) => [`emitters.${emitter}.${name}`, value]),
  );
  return { ...BASE, ...(Object.fromEntries(values) as Values) };
}

function stageWith(values: Values): Promise<Stage> {
  return createStage(new OffscreenCanvas(WIDTH, HEIGHT), { values, width: WIDTH, height: HEIGHT, pixelRatio: 1 });
}

export async function sixLooks(): Promise<Blob> {
  const stage = await stageWith(valuesWith(LOOKS));
  await stage.seek(3);
  const picture = await stage.picture();
  stage.dispose();
  return picture;
}

async function pixelsOf(picture: Blob): Promise<Uint32Array> {
  const bitmap = await createImageBitmap(picture);
  const context = new OffscreenCanvas(WIDTH, HEIGHT).getContext('2d')!;
  context.drawImage(bitmap, 0, 0);
  return new Uint32Array(context.getImageData(0, 0, WIDTH, HEIGHT).data.buffer);
}

async function differing(one: Blob, other: Blob): Promise<number> {
  const [a, b] = await Promise.all([pixelsOf(one), pixelsOf(other)]);
  return a.reduce((sum, pixel, at) => sum + Number(pixel !== b[at]), 0);
}

export interface LookSameness {
  /** Pixels that differ from the picture of a stage without looks. */
  sameColors: number;
  /** From the first stage, of one to which its state was restored and that had other values. */
  restored: number;
  /** Of one that replays its take. */
  replayed: number;
  /** Of its copy. */
  copied: number;
  /** With another colour of the first emitter, which its smoke takes on at once; and whether the hash stayed. */
  recolored: number;
  hasSameHash: boolean;
}

/** A look with the smoke's own tones; a state, a take and a copy of a stage whose looks include those of emissions. */
export async function sameness(): Promise<LookSameness> {
  const plain = { 'style.ramp': '0:806080,.5:f6efe2', 'style.tones': 2 } as const;
  const own = Array.from({ length: EMITTERS }, () => ({ colors: plain['style.ramp'] }));
  const [unlike, like] = await Promise.all(
    [{}, own].map((looks) => stageWith({ ...valuesWith(looks as typeof own), ...plain })),
  );
  for (const stage of [unlike, like]) await stage.seek(2);
  const sameColors = await differing(await unlike.picture(), await like.picture());
  for (const stage of [unlike, like]) stage.dispose();

  const stage = await stageWith(valuesWith(LOOKS));
  stage.step(60);
  for (const x of [-2, 0, 2])
    stage.emit({
      position: { x, y: 1.8, z: 0.3 },
      count: 25,
      speed: 0.6,
      size: 0.25,
      look: { colors: '0:004040,.5:00d0c0', ageColors: '0:ffffff,.5:a0a0ff', lifetime: 3, inkWeight: 0.5 },
    });
  stage.step(40);
  const picture = await stage.picture();
  const other = await stageWith({ ...valuesWith([]), 'emission.rate': 30 });
  other.restore(stage.save());
  const restored = await differing(picture, await other.picture());
  const third = await stageWith(valuesWith([]));
  third.playTake(stage.take());
  third.step(100);
  const replayed = await differing(picture, await third.picture());
  const copy = await stage.copy(new OffscreenCanvas(WIDTH, HEIGHT), { width: WIDTH, height: HEIGHT, pixelRatio: 1 });
  const copied = await differing(picture, await copy.picture());
  const hash = stage.hash();
  stage.set({ 'emitters.0.look.colors': '0:005000,.45:00c000' });
  const recolored = await differing(picture, await stage.picture());
  const hasSameHash = stage.hash() === hash;
  for (const each of [stage, other, third, copy]) each.dispose();
  return { sameColors, restored, replayed, copied, recolored, hasSameHash };
}
