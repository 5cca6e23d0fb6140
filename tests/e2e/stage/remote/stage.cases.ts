/** Remote stages, as a page uses them. */
import type { RemoteStage, RemoteStageOptions } from '../../../../src/stage/remote/contract.ts';
import { openStage } from '../../../../src/stage/remote/openStage.ts';
import { SmokeError, type ParameterError } from '../../../../src/base/errors.ts';
import type { Values } from '../../../../src/parameters/parameter.ts';
import { findPreset, presetValues } from '../../../../src/parameters/presets.ts';
import { PLAIN_LOOK } from '../../../support/plainLook.ts';

const [WIDTH, HEIGHT] = [160, 120];
const SMALL: Values = {
  ...presetValues(findPreset('wisp')!),
  ...PLAIN_LOOK,
  'simulation.maxParticles': 300,
  'puff.variations': 1,
};

export interface Opened {
  stage: RemoteStage;
  canvas: HTMLCanvasElement;
  /** Number of created canvases. */
  made: number;
}

/** A small wisp on the page. The callback gets its canvas before the first picture. */
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

/** Timeout for pictures of a worker, far longer than any machine needs. */
const TIMEOUT_MS = 60_000;

/** Polls until the canvas shows the expected pixels or the timeout ends. @returns the number of pixels that differ */
export async function differingShown(canvas: HTMLCanvasElement, expected: Uint32Array): Promise<number> {
  let count = Infinity;
  for (const until = performance.now() + TIMEOUT_MS; count > 0 && performance.now() < until;) {
    await new Promise(requestAnimationFrame);
    count = differing(await pixelsOf(canvas), expected);
  }
  return count;
}

/** Polls until the canvas shows more than `few` colours: it may show earlier pictures for a while. */
export async function colorsShown(canvas: HTMLCanvasElement, few: number): Promise<number> {
  let colors = 0;
  for (const until = performance.now() + TIMEOUT_MS; colors <= few && performance.now() < until;) {
    await new Promise(requestAnimationFrame);
    colors = new Set(await pixelsOf(canvas)).size;
  }
  return colors;
}

/** The same steps in a worker and on the main thread: pixels that differ, and colours, to detect a blank picture. */
export async function compareThreads() {
  const places = [await open({ thread: 'worker' }), await open({ thread: 'main' })];
  const stages = places.map(({ stage }) => stage);
  for (const stage of stages) await stage.step(150);
  const shown = await pixelsOf(places[1].canvas);
  // Before picture(), which redraws.
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

/** Counts the messages and workers of stages from now on. */
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

/** Resolves when a stage has advanced by this number of steps. */
export async function goesOn(stage: RemoteStage, steps = 5): Promise<void> {
  const goal = (await stage.stats()).steps + steps;
  while ((await stage.stats()).steps < goal) await new Promise(requestAnimationFrame);
}

/** Resolves after the pending IntersectionObserver callbacks. */
export async function sightIsNotified(): Promise<void> {
  await new Promise((resolve) => new IntersectionObserver(resolve).observe(document.body));
  // All observers are called in one task.
  await new Promise((resolve) => setTimeout(resolve));
}

/** Steps of a stage within a number of frames of this page, after pending callbacks. */
export async function stepsWithin(stage: RemoteStage, frames: number): Promise<number> {
  await sightIsNotified();
  const before = (await stage.stats()).steps;
  for (let frame = 0; frame < frames; ++frame) await new Promise(requestAnimationFrame);
  return (await stage.stats()).steps - before;
}

/** An error of a stage as the page receives it. */
export async function thrownBy(act: () => Promise<unknown>) {
  const error = await act().then(
    () => undefined,
    (reason: Error) => reason,
  );
  if (!error) return undefined;
  const { name, message, key, value, accepted } = error as ParameterError;
  return { isOurs: error instanceof SmokeError, name, message, key, value, accepted };
}

/** Errors by cause, and that the state is unchanged. */
export async function errors(thread: 'main' | 'worker') {
  const { stage } = await open({ thread });
  const before = await stage.hash();
  const rejected = {
    range: await thrownBy(() => stage.set({ 'emission.rate': -5 })),
    text: await thrownBy(() => stage.set({ 'emission.rate': '60' as never })),
    unknown: await thrownBy(() => stage.set({ nothing: 1 } as object)),
    scene: await thrownBy(() => stage.enter({ scene: 'moon' as never })),
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

/** Sends a take and a state to the worker and back: the hashes must be equal. */
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

/** Events, and messages that arrive without listeners. */
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

/** Scrolls a stage out of view and back, playing and paused: its steps in the meantime. */
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

/**
 * Starts aborted before they begin, before the worker exists, and after the worker got the request: the result of each.
 */
export async function abortStarts() {
  const controllers = [0, 1, 2].map(() => new AbortController());
  const [atOnce, soon, later] = controllers.map(({ signal }) => signal);
  controllers[0].abort('at once');
  const starts = [
    open({ signal: atOnce }),
    open({ signal: soon }),
    // The request is posted in the task that creates the canvas, and no response can arrive before that task ends.
    open({ signal: later }, () => queueMicrotask(() => controllers[2].abort('later'))),
  ];
  controllers[1].abort('soon');
  return Promise.all(starts.map((start) => start.then(String, String)));
}

/** GPU time of a frame before statistics ask for it, while they do, and afterwards, in milliseconds. */
export async function timeGpu(
  thread: 'main' | 'worker',
): Promise<Record<'before' | 'timed' | 'after', number | undefined>> {
  const { stage } = await open({ thread });
  const next = async (options?: { gpu: boolean }) => {
    await stage.step();
    await new Promise(requestAnimationFrame);
    return (await stage.stats(options)).gpuMs;
  };
  const before = await next();
  let timed: number | undefined;
  for (const until = performance.now() + TIMEOUT_MS; timed === undefined && performance.now() < until;)
    timed = await next({ gpu: true });
  await stage.stats();
  const after = await next();
  await stage.dispose();
  return { before, timed, after };
}
