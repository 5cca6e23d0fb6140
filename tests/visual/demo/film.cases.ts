/** The same frames as `npm run film`, by the page and by `npm run poster`; and a link with a take. */
import { unzipSync } from 'fflate';
import { capture } from '../../../src/demo/capture/capture.ts';
import { downsample } from '../../../src/demo/film/downsample.ts';
import { decode, encode } from '../../../src/parameters/codec.ts';
import { createStage } from '../../../src/stage/stage.ts';

/** Frames of the page's PNG sequence from a time on, in base64. */
export async function sequence(hash: string, start: number, width: number, height: number, scale: number) {
  const { values } = (await decode(hash)).state;
  const stage = await createStage(new OffscreenCanvas(16, 16), { values });
  await stage.seek(start);
  const settings = { format: 'zip', width, height, scale, hasBackground: true, inLayers: false } as const;
  const task = { signal: new AbortController().signal, onProgress: () => undefined };
  const zip = await capture(stage, { ...settings, seconds: 0.1, rate: 24 }, task);
  stage.dispose();
  const files = Object.values(unzipSync(new Uint8Array(await zip.arrayBuffer())));
  return files.map((bytes) => btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join('')));
}

/** The page's loop of 6 frames, 12 a second, without background as an APNG, in base64. */
export async function loop(hash: string, start: number, width: number, height: number) {
  const { values } = (await decode(hash)).state;
  const stage = await createStage(new OffscreenCanvas(16, 16), { values });
  await stage.seek(start);
  const settings = { format: 'apng', width, height, scale: 1, hasBackground: false, inLayers: false } as const;
  const task = { signal: new AbortController().signal, onProgress: () => undefined };
  const file = await capture(stage, { ...settings, seconds: 0.5, rate: 12 }, task);
  stage.dispose();
  return btoa(Array.from(new Uint8Array(await file.arrayBuffer()), (byte) => String.fromCharCode(byte)).join(''));
}

/** Alpha of the pixels of each frame of a WebP, and seconds until the frame. */
export async function webpFrames(base64: string): Promise<{ alpha: number[][]; times: number[]; loops: boolean }> {
  const data = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  const decoder = new ImageDecoder({ data, type: 'image/webp' });
  await decoder.tracks.ready;
  await decoder.completed;
  const { frameCount, repetitionCount } = decoder.tracks.selectedTrack!;
  const [alpha, times]: [number[][], number[]] = [[], []];
  for (let frameIndex = 0; frameIndex < frameCount; ++frameIndex) {
    const { image } = await decoder.decode({ frameIndex });
    const canvas = new OffscreenCanvas(image.displayWidth, image.displayHeight);
    const context = canvas.getContext('2d')!;
    context.drawImage(image, 0, 0);
    times.push(image.timestamp / 1e6);
    image.close();
    const { data: pixels } = context.getImageData(0, 0, canvas.width, canvas.height);
    alpha.push(Array.from(pixels.filter((_, at) => at % 4 === 3)));
  }
  return { alpha, times, loops: repetitionCount === Infinity };
}

/** A link whose smoke is dragged and blown on at several times. */
export async function disturbed(hash: string): Promise<string> {
  const { state } = await decode(hash);
  const canvas = new OffscreenCanvas(160, 90);
  const stage = await createStage(canvas, { values: state.values, width: 160, height: 90 });
  for (let time = 0; time < 5; ++time) {
    stage.step(9);
    stage.nudge({ dx: 0.1, dy: 0.05 });
    stage.step(3);
    stage.blow({ x: 80, y: 30 });
  }
  stage.step(30);
  const link = await encode(state, stage.take().toBytes());
  stage.dispose();
  return link;
}

/** Pictures of frames at 30 a second, in base64 by their number, from a stage that seeks in this order. */
export async function sought(hash: string, order: readonly number[]): Promise<Record<number, string>> {
  const { values } = (await decode(hash)).state;
  const stage = await createStage(new OffscreenCanvas(160, 90), { values });
  const pictures: Record<number, string> = {};
  for (const frame of order) {
    await stage.seek(frame / 30);
    const bytes = new Uint8Array(await (await stage.picture()).arrayBuffer());
    pictures[frame] = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
  }
  stage.dispose();
  return pictures;
}

/** Two by two pixels of these colours as one, and its alpha. */
export function averaged(...colors: readonly (readonly number[])[]): number[] {
  return [...downsample(new ImageData(Uint8ClampedArray.from(colors.flat()), 2, 2), 2).data];
}
