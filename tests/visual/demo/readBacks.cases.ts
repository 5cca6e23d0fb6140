/** What the code decides by pixels that it reads, also in browsers that falsify them. */
import { unzipSync } from 'fflate';
import { capture } from '../../../src/demo/capture/capture.ts';
import type { CaptureSettings } from '../../../src/demo/capture/settings.ts';
import { DepthReader } from '../../../src/demo/film/depth.ts';
import { createDevice } from '../../../src/renderer/gpu/device.ts';
import type { Values } from '../../../src/parameters/parameter.ts';
import { createStage, type Stage } from '../../../src/stage/stage.ts';
import { random } from '../random.ts';

const [WIDTH, HEIGHT] = [160, 120];

/** How a browser falsifies the bytes that a page reads. */
const NOISES = {
  none: () => undefined,
  'the lowest bit of every byte': (bytes: Uint8Array | Uint8ClampedArray, next: () => number) =>
    bytes.forEach((byte, at) => (bytes[at] = byte ^ (next() < 0.5 ? 1 : 0))),
  'the highest bit of one byte': (bytes: Uint8Array | Uint8ClampedArray, next: () => number) => {
    bytes[Math.floor(next() * bytes.length)] ^= 128;
  },
};
export type Noise = keyof typeof NOISES;

async function falsified<Result>(noise: Noise, work: () => Result | Promise<Result>): Promise<Result> {
  const next = random(5);
  const { readPixels } = WebGL2RenderingContext.prototype;
  const { getImageData } = OffscreenCanvasRenderingContext2D.prototype;
  WebGL2RenderingContext.prototype.readPixels = function (this: unknown, ...call: unknown[]) {
    Reflect.apply(readPixels, this, call);
    NOISES[noise](call.at(-1) as Uint8Array, next);
  };
  OffscreenCanvasRenderingContext2D.prototype.getImageData = function (...call) {
    const pixels = getImageData.apply(this, call);
    NOISES[noise](pixels.data, next);
    return pixels;
  };
  try {
    return await work();
  } finally {
    WebGL2RenderingContext.prototype.readPixels = readPixels;
    OffscreenCanvasRenderingContext2D.prototype.getImageData = getImageData;
  }
}

/** What is decided. With `isOther`, the truth is another one, which must be noticed as well. */
type Decision = (noise: Noise, isOther: boolean) => Promise<Record<string, number>>;

/** By the file that reads pixels or decides by them. */
const DECISIONS: Readonly<Record<string, Decision>> = {
  /** The other GPU ignores the depth that fragments write. */
  'renderer/gpu/selfTest.ts': async (noise, isOther) => {
    const { shaderSource } = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.shaderSource = function (shader, source) {
      shaderSource.call(this, shader, isOther ? source.replaceAll(/gl_FragDepth = .*;/g, '') : source);
    };
    const device = createDevice(new OffscreenCanvas(1, 1));
    const writesDepth = await falsified(noise, () => Number(device.writesDepth));
    WebGL2RenderingContext.prototype.shaderSource = shaderSource;
    device.dispose();
    return { writesDepth };
  },
  /** The other picture has no outlines. */
  'demo/capture/svg.ts': async (noise, isOther) => {
    const text = await (await captured(noise, { format: 'svg' }, isOther)).text();
    const root = new DOMParser().parseFromString(text, 'image/svg+xml').documentElement;
    const count = (selector: string) => root.querySelectorAll(selector).length;
    return { ink: count('#ink path'), flats: count('#flats path'), stops: count('stop') };
  },
  /** The other picture has no shadows. */
  'demo/capture/layers.ts': async (noise, isOther) => {
    const files = await unzipped(await captured(noise, { format: 'zip', inLayers: true }, isOther));
    const shadow = await pixelsOf(files['shadow/0001.png']);
    return { shadowed: shadow.filter((pixel) => pixel >>> 24 > 1).length };
  },
  /** Pixels of smoothed edges that no puff covers. The other picture has no outlines. */
  'demo/capture/flipbook.ts': async (noise, isOther) => {
    const settings = { format: 'flipbook', hasBackground: false } as const;
    const files = await unzipped(await captured(noise, settings, isOther));
    const normals = await pixelsOf(files['normals.png']);
    // The decoder rounds where alpha is small.
    const isFacing = (pixel: number) =>
      [128, 128, 255].every((value, channel) => Math.abs(((pixel >>> (8 * channel)) & 0xff) - value) < 8);
    return { facing: normals.filter((pixel) => pixel >>> 24 > 24 && isFacing(pixel)).length };
  },
  /** The other picture has no smoke. */
  'demo/film/depth.ts': async (noise, isOther) => {
    const stage = await lamp(isOther ? 0 : 3);
    const reader = new DepthReader(WIDTH, HEIGHT);
    const metres = await falsified(noise, () => reader.read(stage.running.picture.drawnDepth));
    reader.dispose();
    const found = metres.filter((depth) => depth < Infinity);
    return { empty: metres.length - found.length, mean: found.reduce((sum, depth) => sum + depth) / found.length };
  },
};

export const files = Object.keys(DECISIONS);
export const noises = Object.keys(NOISES) as Noise[];

export function decide(file: string, noise: Noise, isOther: boolean): Promise<Record<string, number>> {
  return DECISIONS[file](noise, isOther);
}

const lamps = new Map<string, Promise<Stage>>();

/** The smoke after some seconds; all noises see the same stage. */
async function lamp(seconds: number, plain: Values = {}): Promise<Stage> {
  const create = async () => {
    const values = { 'simulation.maxParticles': 300, ...plain };
    const stage = await createStage(new OffscreenCanvas(WIDTH, HEIGHT), { values, width: WIDTH, height: HEIGHT });
    await stage.seek(seconds);
    return stage;
  };
  const key = JSON.stringify([seconds, plain]);
  const created = lamps.get(key) ?? create();
  lamps.set(key, created);
  return created;
}

async function captured(noise: Noise, settings: Partial<CaptureSettings>, isPlain: boolean): Promise<Blob> {
  const stage = await lamp(3, isPlain ? { 'style.outlines': 0, 'style.shadows': 0 } : {});
  const size = { width: WIDTH, height: HEIGHT, scale: 1, seconds: 0.04, rate: 24 };
  const whole = { format: 'png', hasBackground: true, inLayers: false, ...size, ...settings } as const;
  const task = { signal: new AbortController().signal, onProgress: () => undefined };
  return falsified(noise, () => capture(stage, whole, task));
}

async function unzipped(zip: Blob): Promise<Record<string, Uint8Array>> {
  return unzipSync(new Uint8Array(await zip.arrayBuffer()));
}

/** The pixels of a PNG as 0xAABBGGRR. */
async function pixelsOf(bytes: Uint8Array): Promise<Uint32Array> {
  const bitmap = await createImageBitmap(new Blob([bytes.slice()]));
  const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d')!;
  context.drawImage(bitmap, 0, 0);
  return new Uint32Array(context.getImageData(0, 0, bitmap.width, bitmap.height).data.buffer);
}
