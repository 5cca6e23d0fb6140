/** Stages from elsewhere, as a page has them. */
import type { RemoteStage, RemoteStageOptions } from '../../src/remote/contract.ts';
import { openStage } from '../../src/remote/openStage.ts';
import { findPreset, presetValues } from '../../src/preset/presets.ts';

const [WIDTH, HEIGHT] = [160, 120];
const SMALL = { ...presetValues(findPreset('wisp')!), 'simulation.maxParticles': 300 };

export interface Opened {
  stage: RemoteStage;
  canvas: HTMLCanvasElement;
  /** How many canvases were asked for. */
  made: number;
}

/** A small wisp on the page. */
export async function open(options: RemoteStageOptions = {}): Promise<Opened> {
  const made: HTMLCanvasElement[] = [];
  const makeCanvas = () => {
    made.at(-1)?.remove();
    const canvas = document.createElement('canvas');
    canvas.style.cssText = `width: ${WIDTH}px; height: ${HEIGHT}px`;
    document.body.append(canvas);
    made.push(canvas);
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
  const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d')!;
  context.drawImage(bitmap, 0, 0);
  return new Uint32Array(context.getImageData(0, 0, bitmap.width, bitmap.height).data.buffer);
}

export function differing(a: Uint32Array, b: Uint32Array): number {
  return a.reduce((count, pixel, index) => count + (pixel === b[index] ? 0 : 1), Math.abs(a.length - b.length));
}

/** The same steps in a worker and on this thread: pixels that differ, and colours, so that a blank picture shows. */
export async function compareThreads() {
  const places = [await open({ thread: 'worker' }), await open({ thread: 'main' })];
  const stages = places.map(({ stage }) => stage);
  for (const stage of stages) await stage.step(150);
  const [worker, main] = await Promise.all(stages.map(async (stage) => pixelsOf(await stage.picture())));
  const [shownByWorker, shownByMain] = await Promise.all(places.map(({ canvas }) => pixelsOf(canvas)));
  const report = {
    threads: stages.map(({ thread }) => thread),
    hashes: await Promise.all(stages.map((stage) => stage.hash())),
    colors: new Set(main).size,
    differing: differing(worker, main),
    differingOnPage: differing(shownByWorker, shownByMain),
    differingShown: differing(shownByMain, main),
  };
  for (const stage of stages) await stage.dispose();
  return report;
}
