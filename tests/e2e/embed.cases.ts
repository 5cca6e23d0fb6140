/** Stages from elsewhere, as a page has them. */
import type { RemoteStage, RemoteStageOptions } from '../../src/remote/contract.ts';
import { openStage } from '../../src/remote/openStage.ts';
import { SmokeError, type ParameterError } from '../../src/preset/errors.ts';
import type { Values } from '../../src/preset/parameter.ts';
import { findPreset, presetValues } from '../../src/preset/presets.ts';

const [WIDTH, HEIGHT] = [160, 120];
const SMALL: Values = { ...presetValues(findPreset('wisp')!), 'simulation.maxParticles': 300, 'puff.variations': 1 };

export interface Opened {
  stage: RemoteStage;
  canvas: HTMLCanvasElement;
  /** How many canvases were asked for. */
  made: number;
}

/** A small wisp on the page. Its canvas is told of before anybody draws on it. */
export async function open(
  options: RemoteStageOptions = {},
  onCanvas?: (canvas: HTMLCanvasElement) => void,
): Promise<Opened> {
  const made: HTMLCanvasElement[] = [];
  const makeCanvas = () => {
    made.at(-1)?.remove();
    const canvas = document.createElement('canvas');
    canvas.style.cssText = `width: ${WIDTH}px; height: ${HEIGHT}px`;
    document.body.append(canvas);
    made.push(canvas);
    onCanvas?.(canvas);
    return canvas;
  };
  const stage = await openStage(makeCanvas, {
    values: SMALL,
    width: WIDTH,
    height: HEIGHT,
    pixelRatio: 1,
    ...options,
  });
  return { stage, canvas: made.at(-1)!, made: made.length };
}

export async function pixelsOf(picture: ImageBitmapSource): Promise<Uint32Array> {
  const bitmap = await createImageBitmap(picture);
  const { width, height } = bitmap;
  const context = Object.assign(document.createElement('canvas'), { width, height }).getContext('2d')!;
  context.drawImage(bitmap, 0, 0);
  return new Uint32Array(context.getImageData(0, 0, width, height).data.buffer);
}

export function differing(a: Uint32Array, b: Uint32Array): number {
  return a.reduce((count, pixel, index) => count + (pixel === b[index] ? 0 : 1), Math.abs(a.length - b.length));
}

/** What a worker draws comes to the page when it can: so long it has, which no machine needs. */
const TIMEOUT_MS = 60_000;

/** Pixels of a canvas on the page that differ from what they should be, once none does, or nobody waits any longer. */
export async function differingShown(canvas: HTMLCanvasElement, expected: Uint32Array): Promise<number> {
  let count = Infinity;
  for (const until = performance.now() + TIMEOUT_MS; count > 0 && performance.now() < until;) {
    await new Promise(requestAnimationFrame);
    count = differing(await pixelsOf(canvas), expected);
  }
  return count;
}

/** Colours on a canvas of the page, once it shows more than so few: it may show earlier pictures for a while. */
export async function colorsShown(canvas: HTMLCanvasElement, few: number): Promise<number> {
  let colors = 0;
  for (const until = performance.now() + TIMEOUT_MS; colors <= few && performance.now() < until;) {
    await new Promise(requestAnimationFrame);
    colors = new Set(await pixelsOf(canvas)).size;
  }
  return colors;
}

/** The same steps in a worker and on this thread: pixels that differ, and colours, so that a blank picture shows. */
export async function compareThreads() {
  const places = [await open({ thread: 'worker' }), await open({ thread: 'main' })];
  const stages = places.map(({ stage }) => stage);
  for (const stage of stages) await stage.step(150);
  const shown = await pixelsOf(places[1].canvas);
  // Before anybody asks for a picture, which is drawn anew.
  const differingOnPage = await differingShown(places[0].canvas, shown);
  const [worker, main] = await Promise.all(stages.map(async (stage) => pixelsOf(await stage.picture())));
  const report = {
    threads: stages.map(({ thread }) => thread),
    hashes: await Promise.all(stages.map((stage) => stage.hash())),
    colors: new Set(main).size,
    differing: [differingOnPage, differing(shown, main), differing(worker, main)],
  };
  for (const stage of stages) await stage.dispose();
  return report;
}

/** What a page sees of a stage's messages and workers, counted from now on. */
export function watch() {
  const seen = { workers: 0, terminated: 0, messages: 0 };
  const { Worker: OriginalWorker, MessageChannel: OriginalChannel } = globalThis;
  globalThis.Worker = class extends OriginalWorker {
    constructor(address: string | URL, options?: WorkerOptions) {
      super(address, options);
      seen.workers += 1;
    }
    override terminate() {
      seen.terminated += 1;
      super.terminate();
    }
  };
  globalThis.MessageChannel = class extends OriginalChannel {
    constructor() {
      super();
      this.port1.addEventListener('message', () => (seen.messages += 1));
    }
  };
  return seen;
}

/** Settled when a stage has come so many steps on. */
export async function goesOn(stage: RemoteStage, steps = 5): Promise<void> {
  const goal = (await stage.stats()).steps + steps;
  while ((await stage.stats()).steps < goal) await new Promise(requestAnimationFrame);
}

/** Settled when whoever observes what is in view has been told how that is now. */
export async function sightIsNotified(): Promise<void> {
  await new Promise((resolve) => new IntersectionObserver(resolve).observe(document.body));
  // All observers are told in one task.
  await new Promise((resolve) => setTimeout(resolve));
}

/** Steps that a stage takes within so many frames of this page, once it has been told of what came before. */
export async function stepsWithin(stage: RemoteStage, frames: number): Promise<number> {
  await sightIsNotified();
  const before = (await stage.stats()).steps;
  for (let frame = 0; frame < frames; ++frame) await new Promise(requestAnimationFrame);
  return (await stage.stats()).steps - before;
}

/** How an error that a stage gives looks on this side. */
export async function thrownBy(act: () => Promise<unknown>) {
  const error = await act().then(
    () => undefined,
    (reason: Error) => reason,
  );
  if (!error) return undefined;
  const { name, message, key, value, accepted } = error as ParameterError;
  return { isOurs: error instanceof SmokeError, name, message, key, value, accepted };
}

/** What goes wrong in each place, and what stays as it was. */
export async function errors(thread: 'main' | 'worker') {
  const { stage } = await open({ thread });
  const before = await stage.hash();
  const rejected = {
    range: await thrownBy(() => stage.set({ 'emission.rate': -5 })),
    text: await thrownBy(() => stage.set({ 'emission.rate': '60' })),
    unknown: await thrownBy(() => stage.set({ nothing: 1 })),
    scene: await thrownBy(() => stage.enter({ scene: 'moon' })),
    bytes: await thrownBy(() => stage.restore(new Uint8Array(8))),
    fraction: await thrownBy(() => stage.step(1.5)),
    negativeStep: await thrownBy(() => stage.step(-1)),
    negativeSeek: await thrownBy(() => stage.seek(-1)),
    negativeAdvance: await thrownBy(() => stage.advance(-0.5)),
    noNumber: await thrownBy(() => stage.seek(NaN)),
  };
  const isSame = before === (await stage.hash());
  await stage.dispose();
  await stage.dispose();
  return { ...rejected, after: await thrownBy(() => stage.play()), isSame };
}

/** A take and a state that went to the worker and back: hashes that have to be equal. */
export async function sendBytes() {
  const { stage } = await open({ thread: 'worker' });
  await stage.step(20);
  await stage.set({ 'emission.rate': 300 });
  await stage.blow({ x: 80, y: 60, dx: 5, dy: 0 });
  await stage.step(20);
  const [first, take, state] = [await stage.hash(), await stage.take(), await stage.save()];
  await stage.restart();
  await stage.playTake(take);
  await stage.seek(40 / 60);
  const second = await stage.hash();
  await stage.step(10);
  await stage.restore(state);
  const hashes = [first, second, await stage.hash()];
  await stage.dispose();
  return { hashes, inputs: take.inputs, isOfStart: take.values['emission.rate'] === SMALL['emission.rate'] };
}

/** Events that come, and messages that come without anybody listening. */
export async function listen(seen: ReturnType<typeof watch>) {
  const { stage } = await open({ thread: 'worker' });
  const notified: boolean[] = [];
  const end = stage.on('statechange', ({ playing }) => notified.push(playing));
  await stage.play();
  await stage.pause();
  end();
  await stage.play();
  await goesOn(stage);
  const before = seen.messages;
  for (let frame = 0; frame < 10; ++frame) await new Promise(requestAnimationFrame);
  const silent = seen.messages - before;
  const steps = await new Promise<number>((resolve) => stage.on('frame', (stats) => resolve(stats.steps)));
  await stage.dispose();
  return { notified, silent, steps };
}

/** Scrolls a stage away and back, playing and paused: steps that it takes meanwhile. */
export async function scroll() {
  const { stage, canvas } = await open();
  const takes = () => stepsWithin(stage, 20);
  await stage.play();
  await goesOn(stage);
  canvas.style.marginTop = '3000px';
  const away = await takes();
  canvas.style.marginTop = '';
  await goesOn(stage);
  await stage.pause();
  canvas.style.marginTop = '3000px';
  await takes();
  canvas.style.marginTop = '';
  const paused = await takes();
  await stage.dispose();
  return { away, paused };
}

/** Starts that are called off before they begin, before there is a worker, and once the worker has its order; how each ended. */
export async function abortStarts() {
  const controllers = [0, 1, 2].map(() => new AbortController());
  const [atOnce, soon, later] = controllers.map(({ signal }) => signal);
  controllers[0].abort('at once');
  const starts = [
    open({ signal: atOnce }),
    open({ signal: soon }),
    // The order goes out in the task that makes the canvas, and no answer can come before that ends.
    open({ signal: later }, () => queueMicrotask(() => controllers[2].abort('later'))),
  ];
  controllers[1].abort('soon');
  return Promise.all(starts.map((start) => start.then(String, String)));
}
