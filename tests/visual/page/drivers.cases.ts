/** Performances of drivers on stages, which their takes replay. */
import { DirectionalLight, WebGLRenderer } from 'three';
import { driveByAudio } from '../../../src/page/drivers/audio.ts';
import type { Driver, DrivenSmoke } from '../../../src/page/drivers/driver.ts';
import { driveByMidi } from '../../../src/page/drivers/midi.ts';
import { driveByPointer } from '../../../src/page/drivers/pointer.ts';
import type { DrivenRanges } from '../../../src/page/drivers/ranges.ts';
import { driveByScroll } from '../../../src/page/drivers/scroll.ts';
import type { AnyValues } from '../../../src/parameters/parameter.ts';
import { openStage } from '../../../src/stage/remote/openStage.ts';
import { createStage, type Stage } from '../../../src/stage/stage.ts';
import { CartoonSmoke } from '../../../src/three/cartoonSmoke.ts';
import { PLAIN_LOOK } from '../../support/plainLook.ts';

const SIZE = { width: 80, height: 60 };
const VALUES = { ...PLAIN_LOOK, scene: 'wisp', 'simulation.maxParticles': 300, 'puff.variations': 1 } as const;
const STEPS = 45;
const DRIVES: DrivenRanges = { 'emission.rate': [5, 200], 'style.smokeColor': ['#000000', '#ff8040'] };

/** A driver, and what the person does in each frame. */
type Performance = (smoke: DrivenSmoke) => Promise<{ driver: Driver; act: (frame: number) => void }>;

const PERFORMANCES = {
  async scroll(smoke) {
    document.body.style.height = '4000px';
    const driver = driveByScroll(smoke, { drives: DRIVES, smoothing: 0.05 });
    return { driver, act: (frame) => scrollTo(0, 40 * frame) };
  },
  async pointer(smoke) {
    const driver = driveByPointer(smoke, { drives: DRIVES });
    const act = (frame: number) =>
      void document.body.dispatchEvent(new PointerEvent('pointermove', { clientX: frame ** 2, bubbles: true }));
    return { driver, act };
  },
  async audio(smoke) {
    const context = new AudioContext();
    await context.resume();
    const oscillator = new OscillatorNode(context, { frequency: 120 });
    const gain = new GainNode(context, { gain: 0 });
    oscillator.connect(gain);
    oscillator.start();
    const driver = driveByAudio(smoke, { audio: gain, low: DRIVES, mid: { 'forces.wind.x': [0, 2] } });
    const act = (frame: number) => {
      gain.gain.value = frame / STEPS;
      if (frame > STEPS / 2) oscillator.frequency.value = 900;
    };
    return { driver: { stop: () => (driver.stop(), void context.close()) }, act };
  },
  async midi(smoke) {
    const input = new EventTarget();
    const access = Object.assign(new EventTarget(), { inputs: new Map([['knobs', input]]) });
    Object.defineProperty(navigator, 'requestMIDIAccess', { value: async () => access, configurable: true });
    const driver = await driveByMidi(smoke, { knobs: { 21: DRIVES }, smoothing: 0.1 });
    const act = (frame: number) => {
      const data = new Uint8Array([0xb0, 21, (frame * 2) % 128]);
      input.dispatchEvent(Object.assign(new Event('midimessage'), { data }));
    };
    return { driver, act };
  },
} satisfies Record<string, Performance>;

export type PerformanceName = keyof typeof PERFORMANCES;

const nextFrame = () => new Promise(requestAnimationFrame);

/** The hash and the colour of a performance and of its replay, and the number of changes of the performance. */
export async function replayed(
  name: PerformanceName,
): Promise<{ played: unknown[]; again: unknown[]; changes: number }> {
  const stage = await open();
  const seen = new Set<unknown>();
  await perform(name, stage, async (frame) => {
    seen.add(stage.get()['emission.rate']);
    if (frame < STEPS) stage.step();
  });
  const bytes = stage.take().toBytes();
  const other = await open();
  other.playTake(bytes);
  other.step(STEPS);
  // The code of logs is loaded first.
  await other.complete();
  const report = { played: end(stage), again: end(other), changes: seen.size };
  for (const each of [stage, other]) each.dispose();
  return report;
}

/** The same on another thread. */
export async function replayedRemotely(
  thread: 'main' | 'worker',
): Promise<{ played: unknown[]; again: unknown[]; changes: number }> {
  const canvases = [0, 0].map(() => document.body.appendChild(document.createElement('canvas')));
  const [stage, other] = await Promise.all(
    canvases.map((canvas) => openStage(() => canvas, { values: VALUES, ...SIZE, thread })),
  );
  const seen = new Set<unknown>();
  await perform('scroll', stage, async (frame) => {
    seen.add((await stage.get())['emission.rate']);
    if (frame < STEPS) await stage.step(1);
  });
  await other.playTake(await stage.take());
  await other.step(STEPS);
  const ends = await Promise.all([stage, other].map(async (each) => [await each.hash(), colorOf(await each.get())]));
  await Promise.all([stage.dispose(), other.dispose()]);
  for (const canvas of canvases) canvas.remove();
  return { played: ends[0], again: ends[1], changes: seen.size };
}

/** The number of different rates of smoke in a scene of three.js, and the key of the error of a camera's parameter. */
export async function hosted(): Promise<{ changes: number; key: unknown }> {
  const renderer = new WebGLRenderer({ stencil: true });
  const values = { ...PLAIN_LOOK, 'simulation.maxParticles': 300, 'puff.variations': 1 } as const;
  const smoke = await CartoonSmoke.create({ renderer, keyLight: new DirectionalLight(), values });
  const seen = new Set<unknown>();
  await perform('scroll', smoke, async () => {
    seen.add(smoke.get()['emission.rate']);
    smoke.update(1 / 60);
  });
  let key: unknown;
  try {
    driveByScroll(smoke, { drives: { 'camera.azimuth': [0, 90] } });
  } catch (error) {
    ({ key } = error as { key: unknown });
  }
  smoke.dispose();
  renderer.dispose();
  return { changes: seen.size, key };
}

/** The rate that is shown at steps around the next keyframe of a parameter that a driver changes once, at step 10. */
export async function held(): Promise<unknown[]> {
  const stage = await createStage(document.createElement('canvas'), {
    values: { ...VALUES, timeline: '60;emission.rate/0*5*h/30*90' },
    ...SIZE,
  });
  document.body.style.height = '4000px';
  scrollTo(0, 0);
  await nextFrame();
  stage.step(10);
  const driver = driveByScroll(stage, { drives: { 'emission.rate': [40, 200] } });
  const rates: unknown[] = [];
  for (const steps of [1, 18, 2]) {
    await nextFrame();
    stage.step(steps);
    rates.push(stage.shown['emission.rate']);
  }
  driver.stop();
  stage.dispose();
  return rates;
}

function open(): Promise<Stage> {
  return createStage(document.createElement('canvas'), { values: VALUES, ...SIZE });
}

/** @param follow takes a step, but in the last frame */
async function perform(
  name: PerformanceName,
  smoke: DrivenSmoke,
  follow: (frame: number) => Promise<void>,
): Promise<void> {
  const { driver, act } = await PERFORMANCES[name](smoke);
  for (let frame = 0; frame <= STEPS; ++frame) {
    act(frame);
    await nextFrame();
    await follow(frame);
  }
  driver.stop();
  scrollTo(0, 0);
}

const colorOf = (values: AnyValues) => values['style.smokeColor'];

function end(stage: Stage): unknown[] {
  return [stage.hash(), colorOf(stage.shown)];
}
