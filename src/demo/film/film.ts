/** Renders the frames of a shot and sends them to the command that opened the page. */
import { createStage, type Stage } from '../../index.ts';
import {
  encodePng,
  linkCapacity,
  lookOf,
  LoopJoin,
  PixelReader,
  readEnvironment,
  requireSize,
  STEP_SECONDS,
  type Studio,
} from '../../internal.ts';
import { decode, encode, type Decoded } from '../../preset.ts';
import { drawFlipbook } from '../capture/flipbook.ts';
import { LayerCamera, type Layer } from '../capture/layers.ts';
import { rendererName } from '../costs/gpuClock.ts';
import { strings } from '../strings.ts';
import { DepthReader } from './depth.ts';
import { brightest, downsample, nearest } from './downsample.ts';
import { encodeDepth, encodeExr } from './exr.ts';
import { encodeFrames, pictureOf } from './frameVideo.ts';
import { messages, type Receiver } from './receiver.ts';
import { finishStinger, wipeOf } from './stinger.ts';
import { nameOf, type Beginning, type DrawnFrame, type FilmOrder, type FlipbookOrder, type Keyframe } from './order.ts';

/** Renders the frames that the receiver asks for, in ascending order. */
export async function film(order: FilmOrder, receiver: Receiver): Promise<void> {
  const { stage, canvas, beginning } = await openShot(order);
  try {
    const frames = await receiver.begin(beginning);
    if (frames.length > 0) await new Shooting(order, stage, canvas, beginning.start, receiver).shoot(frames);
  } finally {
    stage.dispose();
  }
  const { stinger } = order;
  if (stinger) return finishStinger({ ...order, stinger }, beginning.last!, receiver);
  if (!order.video) return;
  const pictures = { ...order, get: (frame: number) => pictureOf(frame, receiver) };
  await receiver.putVideo(await encodeFrames(pictures, order.video));
}

/** Draws a flipbook and sends its files. */
export async function flipbook(order: FlipbookOrder, receiver: Receiver): Promise<void> {
  const { columns, rows, width, height, scale, seconds, lights } = order;
  const { stage, canvas, beginning } = await openShot({
    ...order,
    hasBackground: false,
    supersample: 1,
    fps: 1,
    camera: [],
  });
  try {
    await stage.seek(beginning.start);
    const studio = { stage, canvas, draw: () => stage.resize(width / scale, height / scale, scale) };
    const css = { width: width / scale, height: height / scale, scale };
    const clip = { hasBackground: false, inLayers: false, lights, seconds, rate: (columns * rows) / seconds };
    const task = {
      signal: new AbortController().signal,
      onProgress: (share: number) => void receiver.progress(share).catch(() => undefined),
    };
    const files = await drawFlipbook(studio, { ...clip, ...css, format: 'flipbook' }, task, columns);
    for (const [name, file] of files) await receiver.put(name, file);
  } finally {
    stage.dispose();
  }
}

interface Shot {
  readonly stage: Stage;
  readonly canvas: HTMLCanvasElement;
  readonly beginning: Beginning;
}

type ShotOrder = Omit<FilmOrder, 'layers' | 'format' | 'statesEvery'>;

async function openShot(order: ShotOrder): Promise<Shot> {
  const { search, hash } = new URL(order.link, 'http://localhost');
  const environment = readEnvironment(search);
  const decoded = await decode(hash);
  const problems = [...decoded.notices, ...environment.notices].map(({ message }) => message);
  if (problems.length > 0) throw new Error(messages.badLink(problems));
  const wipe = order.stinger && wipeOf(order.stinger, order, decoded.state.values);
  const canvas = document.createElement('canvas');
  const stage = await createStage(canvas, {
    values: wipe?.values ?? decoded.state.values,
    width: 1,
    height: 1,
    background: order.hasBackground,
    historyBytes: 0,
  });
  requireSize(canvas, order.width * order.supersample, order.height * order.supersample);
  if (wipe) for (const emission of wipe.emissions) stage.emit(emission);
  else await replay(stage, decoded);
  // Checks their ranges. Each frame sets all of these keys again.
  for (const { values } of order.camera) stage.set(values);
  await stage.complete();
  const link = await encode(decoded.state, decoded.take as Uint8Array<ArrayBuffer> | undefined);
  const start = wipe ? 0 : (environment.time ?? 0);
  return {
    stage,
    canvas,
    beginning: { renderer: rendererName(canvas.getContext('webgl2')!), link, start, last: wipe?.last },
  };
}

/** Goes to the start of the link's take. */
async function replay(stage: Stage, { take: bytes, state }: Decoded): Promise<void> {
  if (!bytes) return;
  const take = stage.readTake(bytes);
  const max = linkCapacity();
  if (!take.isFresh) throw new Error(strings.moment.notFresh);
  if (take.mostParticles > max) throw new Error(strings.moment.tooMany(take.mostParticles, max));
  if (take.values.scene !== stage.get().scene) await stage.enter(take.values);
  stage.playTake(take);
  stage.set(lookOf(state.values, take));
}

interface Drawn extends Omit<DrawnFrame, 'encodeMs'> {
  readonly encodeMs: Promise<number>;
  /** The files by name. */
  readonly encoded: Promise<(readonly [string, Blob])[]>;
}

class Shooting {
  private readonly order: FilmOrder;
  private readonly studio: Studio;
  private readonly start: number;
  private readonly receiver: Receiver;
  private readonly reader: PixelReader;
  private readonly encoder: PixelReader;
  private readonly layers: LayerCamera | undefined;
  private readonly depth: DepthReader | undefined;
  private readonly join: LoopJoin | undefined;

  constructor(order: FilmOrder, stage: Stage, canvas: HTMLCanvasElement, start: number, receiver: Receiver) {
    const { width, height, scale, supersample } = order;
    const drawn = [width * supersample, height * supersample] as const;
    const draw = () => stage.resize(width / scale, height / scale, scale * supersample);
    this.order = order;
    this.studio = { stage, canvas, draw };
    this.start = start;
    this.receiver = receiver;
    this.reader = new PixelReader(...drawn);
    this.encoder = new PixelReader(width, height);
    this.layers = order.layers ? new LayerCamera(this.studio, ...drawn) : undefined;
    this.depth = order.layers && order.format === 'exr' ? new DepthReader(...drawn) : undefined;
    const { loop, fps } = order;
    this.join = loop && new LoopJoin(stage, loop.last - loop.first + 1, fps);
  }

  async shoot(frames: readonly number[]): Promise<void> {
    const { join } = this;
    const stills = join?.needsStill(this.shotOf(frames.at(-1)!)) ? join.lead : 0;
    const first = stills > 0 ? this.order.loop!.first - stills : frames[0];
    const step = stepOf(this.secondsAt(first));
    await this.resume(step);
    await this.saveStates(first);
    await this.goTo(step);
    this.studio.draw();
    for (let shot = 0; shot < stills; ++shot) {
      this.show(first + shot);
      join!.keep();
    }
    let sending = Promise.resolve();
    for (const frame of frames) {
      await this.saveStates(frame);
      const drawn = await this.draw(frame);
      // One frame is encoded and sent while the next one is drawn.
      await sending;
      sending = this.send(drawn);
      // Awaited above or below, where its error is thrown.
      sending.catch(() => undefined);
    }
    await sending;
  }

  /** The shot of the loop that a frame is. */
  private shotOf(frame: number): number {
    return frame - this.order.loop!.first + this.join!.lead;
  }

  private show(frame: number): void {
    if (this.join) this.join.shot = this.shotOf(frame);
    const seconds = this.secondsAt(frame);
    this.studio.stage.running.showAt(seconds, cameraAt(this.order.camera, seconds - this.start));
  }

  private secondsAt(frame: number): number {
    return this.start + (frame + (this.join?.lead ?? 0)) / this.order.fps;
  }

  /** Goes to the latest saved state at or before a step, if there is one. */
  private async resume(step: number): Promise<void> {
    if (this.order.statesEvery === 0) return;
    const state = await this.receiver.state(step);
    if (!state) return;
    const { stage } = this.studio;
    stage.running.rewind(state.bytes);
    if (stage.hash() !== state.hash) throw new Error(messages.otherState(state.hash, stage.hash()));
  }

  /** Saves the states up to a frame. */
  private async saveStates(frame: number): Promise<void> {
    const { stage } = this.studio;
    const { statesEvery } = this.order;
    if (statesEvery === 0) return;
    const first = Math.ceil((stage.stats.time - this.start) / (statesEvery / this.order.fps));
    for (let saved = Math.max(1, first) * statesEvery; saved <= frame; saved += statesEvery) {
      await this.goTo(stepOf(this.secondsAt(saved)));
      await this.receiver.save(stage.stats.steps, stage.hash(), stage.save());
    }
  }

  /** Takes steps and draws the last one, so it is not used between frames. */
  private async goTo(step: number): Promise<void> {
    const { stage } = this.studio;
    if (stage.stats.steps < step) await stage.seek(step * STEP_SECONDS);
  }

  private async draw(frame: number): Promise<Drawn> {
    const { stage, canvas } = this.studio;
    const { format, supersample } = this.order;
    const began = performance.now();
    this.show(frame);
    this.waitForGpu();
    const drawMs = performance.now() - began;
    const isPlain = format === 'png' && supersample === 1;
    const whole = isPlain ? encodePng(canvas) : this.encode(this.reader.read(canvas));
    const readMs = performance.now() - began - drawMs;
    const pictures: [Layer | undefined, Promise<Blob>][] = [[undefined, whole]];
    for (const [layer, pixels] of (await this.layers?.shoot()) ?? []) {
      pictures.push([layer, layer === 'depth' ? this.encodeDepth(pixels) : this.encode(pixels)]);
    }
    const named = pictures.map(async ([layer, blob]) => [nameOf(frame, layer, format), await blob] as const);
    const encoded = Promise.all(named);
    const encodeMs = encoded.then(() => performance.now() - began - drawMs - readMs);
    return { frame, step: stage.stats.steps, hash: stage.hash(), drawMs, readMs, encodeMs, encoded };
  }

  private async send({ encoded, encodeMs, ...frame }: Drawn): Promise<void> {
    for (const [name, blob] of await encoded) await this.receiver.put(name, blob);
    await this.receiver.finish({ ...frame, encodeMs: await encodeMs });
  }

  private async encode(pixels: ImageData): Promise<Blob> {
    const small = downsample(pixels, this.order.supersample);
    return this.order.format === 'exr' ? encodeExr(small) : this.encoder.encode(small);
  }

  private async encodeDepth(pixels: ImageData): Promise<Blob> {
    const { width, height, supersample } = this.order;
    if (!this.depth) return this.encoder.encode(brightest(pixels, supersample));
    const metres = this.depth.read(this.studio.stage.running.picture.drawnDepth);
    return encodeDepth(nearest(metres, width * supersample, height * supersample, supersample), width, height);
  }

  /** Reading a pixel waits for the GPU, so that the time of drawing is not counted as encoding. */
  private waitForGpu(): void {
    const context = this.studio.canvas.getContext('webgl2')!;
    context.readPixels(0, 0, 1, 1, context.RGBA, context.UNSIGNED_BYTE, new Uint8Array(4));
  }
}

/** The step after which a time can be shown. */
function stepOf(seconds: number): number {
  return Math.max(0, Math.ceil(seconds / STEP_SECONDS - 1e-6));
}

/**
 * Camera values at a time: linear between two keyframes, by the shorter way around for `camera.azimuth`, and constant
 * before the first and after the last one. A key that a keyframe omits keeps the value between its neighbours.
 * @param keyframes in the order of their times
 */
export function cameraAt(keyframes: readonly Keyframe[], seconds: number): Record<string, number> {
  const keys = new Set(keyframes.flatMap(({ values }) => Object.keys(values)));
  return Object.fromEntries([...keys].map((key) => [key, valueAt(keyframes, key, seconds)]));
}

function valueAt(keyframes: readonly Keyframe[], key: string, seconds: number): number {
  const own = keyframes.filter(({ values }) => key in values);
  const after = own.findIndex((keyframe) => keyframe.seconds > seconds);
  if (after === 0) return own[0].values[key];
  if (after < 0) return own.at(-1)!.values[key];
  const [from, to] = [own[after - 1], own[after]];
  const share = (seconds - from.seconds) / (to.seconds - from.seconds);
  const [start, way] = [from.values[key], to.values[key] - from.values[key]];
  if (key !== 'camera.azimuth') return start + share * way;
  return wrapped(start + share * wrapped(way));
}

/** To degrees from -180 to 180. */
function wrapped(degrees: number): number {
  return degrees - 360 * Math.round(degrees / 360);
}
