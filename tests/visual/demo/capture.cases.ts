/** Captures of a small lamp scene, and the decoded content of the files. */
import { unzipSync } from 'fflate';
import { ALL_FORMATS, BlobSource, EncodedPacketSink, Input, VideoSampleSink } from 'mediabunny';
import { hevcWithAlpha } from '../../../src/demo/capture/clips/hevc.ts';
import { compareFormats } from '../../../src/demo/capture/compare.ts';
import { capture } from '../../../src/demo/capture/capture.ts';
import type { CaptureSettings, Format } from '../../../src/demo/capture/settings.ts';
import { SettingsForm } from '../../../src/demo/capture/settingsForm.ts';
import type { Values } from '../../../src/parameters/parameter.ts';
import type { FlipbookLayout } from '../../../src/demo/capture/flipbook.ts';
import type { LightLayout } from '../../../src/demo/capture/settings.ts';
import { decodePng } from '../../../src/demo/gallery/straightPng.ts';
import type { PixelImage } from '../../../src/index.ts';
import { clip } from '../../../src/page/clip/clip.ts';
import { createStage, type Stage } from '../../../src/stage/stage.ts';

const [WIDTH, HEIGHT] = [160, 120];
const PLAIN: CaptureSettings = {
  format: 'png',
  width: WIDTH,
  height: HEIGHT,
  scale: 1,
  hasBackground: true,
  seconds: 0.25,
  rate: 24,
  inLayers: false,
};

let opened: Promise<Stage> | undefined;

const VALUES: Values = {
  'simulation.maxParticles': 300,
  // Ink whose colour is not that of the parameter.
  'style.inkColor': '#ffe0a0',
  'style.inkLight': 1,
  'light.intensity': 0.3,
  'light.ambient': 0.5,
};

/** Values with light marks on smoke in dim light. */
const PRINTED: Values = {
  'style.tones': 3,
  'style.pattern': 'lines',
  'style.patternOn': 'both',
  'style.patternCoverage': 0.6,
  'style.patternSize': 3,
  'style.patternColor': '#ffffff',
};

/** Runs captures of smoke with marks. */
async function printed<Report>(work: () => Promise<Report>): Promise<Report> {
  const stage = await lamp();
  stage.set(PRINTED);
  await stage.complete();
  const report = await work();
  stage.set({ 'style.pattern': 'none', 'style.tones': 2 });
  await stage.complete();
  return report;
}

/** One stage for all tests, with smoke. */
function lamp(): Promise<Stage> {
  opened ??= createStage(new OffscreenCanvas(WIDTH, HEIGHT), { values: VALUES }).then(async (stage) => {
    await stage.seek(3);
    stage.camera.orbit(0.4, 0.1);
    return stage;
  });
  return opened;
}

async function captured(settings: Partial<CaptureSettings>, signal = new AbortController().signal): Promise<Blob> {
  return capture(await lamp(), { ...PLAIN, ...settings }, { signal, onProgress: () => undefined });
}

/** Runs captures and reports whether the smoke is unchanged afterwards. */
export async function untouched<Report>(work: () => Promise<Report>): Promise<Report & { isUntouched: boolean }> {
  const stage = await lamp();
  const before = [stage.hash(), stage.stats.steps, (await bytesOf(await stage.picture())).join()];
  const report = await work();
  const after = [stage.hash(), stage.stats.steps, (await bytesOf(await stage.picture())).join()];
  return { ...report, isUntouched: before.join() === after.join() };
}

let large: Promise<ImageData> | undefined;

/** At scale 2 and without background; memoized for all tests. */
function largeCut(): Promise<ImageData> {
  large ??= captured({ scale: 2, hasBackground: false }).then(pixelsOf);
  return large;
}

export function still() {
  return untouched(async () => {
    const same = await pixelsOf(await captured({}));
    const stage = await lamp();
    const shown = await pixelsOf(await stage.picture());
    const cut = await largeCut();
    const flats = commonest(cut, 4);
    return {
      differing: differing(same, shown),
      size: [cut.width, cut.height],
      foreignFlats: flats.filter((color) => !commonest(shown, 40).includes(color)),
      alphaOfCorner: cut.data[3],
    };
  });
}

/** A loop without background, and its first frames as a PNG sequence. */
export function loop(format: 'gif' | 'apng' | 'webp') {
  return untouched(async () => {
    const length = { rate: 12, seconds: 0.5, hasBackground: format === 'gif' } as const;
    const file = await captured({ ...length, format });
    const { frames, times, loops } = await decoded(file);
    const shown = await pixelsOf(await (await lamp()).picture());
    // The same moments without the transition of the loop back to the first one.
    const straight = Object.values(unzipSync(await bytesOf(await captured({ ...length, format: 'zip' }))));
    const [first, last] = [await pixelsOfBytes(straight[0]), await pixelsOfBytes(straight.at(-1)!)];
    return {
      frameCount: frames.length,
      times,
      loops,
      type: file.type,
      kept: commonest(shown, 20).filter((color) => commonest(frames[0], 256).includes(color)).length,
      moves: frames.map((frame, at) => differing(frame, frames[(at + 1) % frames.length], 24)),
      jump: differing(first, last, 24),
      file: await base64Of(file),
      straight: await Promise.all(straight.map((bytes) => base64Of(new Blob([bytes])))),
      pixels: await Promise.all(frames.map(({ data }) => base64Of(new Blob([data])))),
    };
  });
}

async function base64Of(blob: Blob): Promise<string> {
  return btoa(Array.from(await bytesOf(blob), (byte) => String.fromCharCode(byte)).join(''));
}

async function decoded(blob: Blob): Promise<{ frames: ImageData[]; times: number[]; loops: boolean }> {
  // The decoder of PNGs reads animated ones, too.
  const type = blob.type === 'image/apng' ? 'image/png' : blob.type;
  const decoder = new ImageDecoder({ data: await bytesOf(blob), type });
  await decoder.tracks.ready;
  await decoder.completed;
  const { frameCount, repetitionCount } = decoder.tracks.selectedTrack!;
  const [frames, times]: [ImageData[], number[]] = [[], []];
  for (let frameIndex = 0; frameIndex < frameCount; ++frameIndex) {
    const { image } = await decoder.decode({ frameIndex });
    times.push(image.timestamp / 1e6);
    frames.push(pixelsOfFrame(image));
  }
  return { frames, times, loops: repetitionCount === Infinity };
}

export function video(format: 'webm' | 'mp4', hasBackground = true) {
  return untouched(async () => {
    const blob = await captured({ format, hasBackground, width: WIDTH - 1 });
    const input = new Input({ source: new BlobSource(blob), formats: ALL_FORMATS });
    const track = (await input.getPrimaryVideoTrack())!;
    const times: number[] = [];
    const moves: number[] = [];
    let last: ImageData | undefined;
    for await (const sample of new VideoSampleSink(track).samples()) {
      times.push(sample.timestamp);
      const pixels = pixelsOfFrame(sample.toVideoFrame());
      sample.close();
      if (last) moves.push(differing(last, pixels, 24));
      last = pixels;
    }
    const stills = unzipSync(await bytesOf(await captured({ format: 'zip', hasBackground, width: WIDTH - 1 })));
    const frames = await Promise.all(Object.values(stills).map(pixelsOfBytes));
    return {
      times,
      moves,
      drawnMoves: frames.slice(1).map((frame, at) => differing(frames[at], frame, 24)),
      size: [track.displayWidth, track.displayHeight],
      corner: last!.data[3],
    };
  });
}

export function sequence(inLayers: boolean) {
  return untouched(async () => {
    const settings = inLayers ? { inLayers, scale: 2, seconds: 0.04 } : { seconds: 0.125 };
    const blob = await captured({ ...settings, format: 'zip', hasBackground: false });
    const entries = unzipSync(await bytesOf(blob));
    const names = Object.keys(entries).sort();
    const pictures = await Promise.all(names.map((name) => pixelsOfBytes(entries[name])));
    const corners = pictures.map(({ data }) => data[3]);
    return { names, corners, composed: inLayers ? await composedError(pictures) : differing(pictures[0], pictures[1]) };
  });
}

/** Pixels in the colour of the smoke, in the flats and among the surfaces. */
export function withoutSmoke() {
  return untouched(async () => {
    const stage = await lamp();
    const { 'style.smokeColor': before } = stage.get();
    stage.set({ 'style.smokeColor': '#00ff00' });
    const entries = unzipSync(await bytesOf(await captured({ format: 'zip', inLayers: true, seconds: 0.04 })));
    stage.set({ 'style.smokeColor': before });
    const [flats, surfaces] = await Promise.all(
      ['flats', 'surfaces'].map((layer) => pixelsOfBytes(entries[`${layer}/0001.png`])),
    );
    return { flats: countGreen(flats), surfaces: countGreen(surfaces), drawn: commonest(surfaces, 50).length };
  });
}

function countGreen({ data }: ImageData): number {
  return data.filter((value, at) => at % 4 === 1 && value > 90 + Math.max(data[at - 1], data[at + 1])).length;
}

/** As {@link sequence} in layers, of smoke with marks; and the number of pixels with a mark. */
export function printedLayers() {
  return printed(async () => {
    const settings = { inLayers: true, scale: 2, seconds: 0.04, format: 'zip', hasBackground: false } as const;
    const entries = unzipSync(await bytesOf(await captured(settings)));
    const names = Object.keys(entries).sort();
    const order = ['flats', 'shadow', 'ink', 'marks'].map((layer) => pixelsOfBytes(entries[`${layer}/0001.png`]));
    const layers = await Promise.all(order);
    const whole = await pixelsOf(await captured({ scale: 2, hasBackground: false }));
    return { names, error: meanDifference(await composed(layers), whole), marked: countOpaque(layers[3]) };
  });
}

/** Ink and shadow come and go, and ink changes its colour, at times between the frames of a clip that begins at step 180. */
const MOVING = '600;style.inkColor/180*00ff00/188*ff0000;style.outlines/0*1/182*0/186*1;style.shadows/0*1/184*0';

/** The frames of a clip with a timeline: errors of their composed layers, and which of them have ink and shadow. */
export function animatedLayers() {
  return untouched(async () => {
    const stage = await lamp();
    stage.set({ timeline: MOVING });
    await stage.complete();
    const before = stage.shown;
    const settings = { scale: 2, seconds: 0.17, format: 'zip', hasBackground: false } as const;
    const plain = unzipSync(await bytesOf(await captured(settings)));
    const entries = unzipSync(await bytesOf(await captured({ ...settings, inLayers: true })));
    const errors: number[] = [];
    const parts: [ink: boolean, shadow: boolean][] = [];
    for (const name of ['0001', '0002', '0003', '0004']) {
      const order = ['flats', 'shadow', 'ink'].map((layer) => pixelsOfBytes(entries[`${layer}/${name}.png`]));
      const layers = await Promise.all(order);
      errors.push(meanDifference(await composed(layers), await pixelsOfBytes(plain[`frame-${name}.png`])));
      parts.push([countOpaque(layers[2]) > 20, countOpaque(layers[1]) > 20]);
    }
    const isSame = JSON.stringify(stage.shown) === JSON.stringify(before);
    stage.set({ timeline: '' });
    return { errors, parts, isSame };
  });
}

function countOpaque({ data }: ImageData): number {
  return data.filter((value, at) => at % 4 === 3 && value > 200).length;
}

/** Composes flats, shadow and ink and compares the result with the picture: mean difference of a channel, 0 to 255. */
async function composedError([, flats, ink, shadow]: ImageData[]): Promise<number> {
  return meanDifference(await composed([flats, shadow, ink]), await largeCut());
}

async function composed(layers: readonly ImageData[]): Promise<ImageData> {
  const [width, height] = [2 * WIDTH, 2 * HEIGHT];
  const context = new OffscreenCanvas(width, height).getContext('2d')!;
  for (const layer of layers) context.drawImage(await createImageBitmap(layer), 0, 0);
  return context.getImageData(0, 0, width, height);
}

export function flipbook() {
  return untouched(async () => {
    const settings = { format: 'flipbook', hasBackground: false, scale: 0.5, rate: 12, seconds: 0.5 } as const;
    const entries = unzipSync(await bytesOf(await captured(settings)));
    const layout: unknown = JSON.parse(new TextDecoder().decode(entries['flipbook.json']));
    const { 'color.png': color, 'channels.png': channels, 'normals.png': normals, 'motion.png': motion } = entries;
    const [colors, light, directions, vectors] = await Promise.all(
      [color, channels, normals, motion].map(pixelsOfBytes),
    );
    const straight = Object.values(unzipSync(await bytesOf(await captured({ ...settings, format: 'zip' }))));
    const first = await pixelsOfBytes(straight[0]);
    const cells = [0, 1, 2, 3, 4, 5].map((cell) => cropped(colors, 80 * (cell % 3), 60 * Math.floor(cell / 3), 80, 60));
    return {
      names: Object.keys(entries).sort(),
      layout,
      size: [colors.width, colors.height],
      // The loop begins where its transition ends, after a quarter of a second.
      isFirst: differing(cells[0], await pixelsOfBytes(straight[3])) === 0,
      isStart: differing(cells[0], first) === 0,
      moves: cells.map((cell, at) => differing(cell, cells[(at + 1) % 6], 24)),
      motion: new Set(new Uint32Array(vectors.data.buffer)).size,
      alpha: alphaDifference(colors, light) + alphaDifference(colors, directions),
      channels: [0, 2].map((channel) => new Set(light.data.filter((_, at) => at % 4 === channel)).size),
    };
  });
}

/** Light maps of rising smoke, one frame. @param glow 0 or 1 */
export async function lightMaps(lights: LightLayout, glow: number) {
  const values: Values = { scene: 'air', 'emission.glow': `0:${glow},1:${glow}`, 'simulation.maxParticles': 300 };
  const stage = await createStage(new OffscreenCanvas(WIDTH, HEIGHT), { values });
  await stage.seek(3);
  const settings = { ...PLAIN, format: 'flipbook', hasBackground: false, rate: 12, seconds: 1 / 12, lights } as const;
  const blob = await capture(stage, settings, { signal: new AbortController().signal, onProgress: () => undefined });
  stage.dispose();
  const entries = unzipSync(await bytesOf(blob));
  const { light } = JSON.parse(new TextDecoder().decode(entries['flipbook.json'])) as FlipbookLayout;
  const maps = await Promise.all(light!.files.map((name) => decodePng(new File([entries[name]], name))));
  const sides = maps.flatMap((map, at) => light!.channels[at].map((name, channel) => [name, momentsOf(map, channel)]));
  return {
    sides: Object.fromEntries(sides) as Readonly<Record<string, Moments>>,
    order: light!.channels.flat(),
  };
}

interface Moments {
  readonly sum: number;
  readonly most: number;
  /** Centre of the light in pixels from the upper left corner. */
  readonly x: number;
  readonly y: number;
}

function momentsOf({ data, width }: PixelImage, channel: number): Moments {
  let [sum, most, x, y] = [0, 0, 0, 0];
  for (let at = channel; at < data.length; at += 4) {
    const pixel = (at - channel) / 4;
    sum += data[at];
    most = Math.max(most, data[at]);
    x += data[at] * (pixel % width);
    y += data[at] * Math.floor(pixel / width);
  }
  return { sum, most, x: x / sum, y: y / sum };
}

function cropped({ data, width }: ImageData, left: number, top: number, columns: number, rows: number): ImageData {
  const result = new ImageData(columns, rows);
  for (let y = 0; y < rows; ++y) {
    const at = 4 * ((top + y) * width + left);
    result.data.set(data.subarray(at, at + 4 * columns), 4 * columns * y);
  }
  return result;
}

/** Pixels that only one of two pictures covers. */
function alphaDifference(a: ImageData, b: ImageData): number {
  return a.data.filter((value, at) => at % 4 === 3 && value > 0 !== b.data[at] > 0).length;
}

export function drawing() {
  return untouched(async () => {
    const blob = await captured({ format: 'svg', scale: 2, hasBackground: false });
    const text = await blob.text();
    const root = new DOMParser().parseFromString(text, 'image/svg+xml').documentElement;
    const picture = await largeCut();
    const fills = [...root.querySelectorAll('path')].map((path) => path.getAttribute('fill'));
    return {
      groups: [...root.children].map(({ id }) => id),
      bytes: blob.size,
      missing: commonest(picture, 5)
        .map(hexOf)
        .filter((color) => !fills.includes(color)),
      error: meanDifference(await rasterised(text, picture), picture),
    };
  });
}

/**
 * A drawing of smoke with marks: its groups, patterns and paths that they fill, the difference to the picture, and means
 * of the picture, of the drawing and of the drawing without marks.
 */
export function printedDrawing() {
  return printed(async () => {
    const settings = { scale: 2, hasBackground: false } as const;
    const text = await (await captured({ ...settings, format: 'svg' })).text();
    const root = new DOMParser().parseFromString(text, 'image/svg+xml').documentElement;
    const picture = await pixelsOf(await captured(settings));
    const marks = root.querySelector('#marks');
    return {
      groups: [...root.children].map(({ id }) => id),
      patterns: [...root.querySelectorAll('pattern')].map(({ id }) => id),
      fills: [...(marks?.querySelectorAll('path') ?? [])].map((path) => path.getAttribute('fill')),
      bytes: text.length,
      error: meanDifference(await rasterised(text, picture), picture),
      // Lines of a pattern are elsewhere than those on puffs, but cover as much.
      means: [picture, await rasterised(text, picture), await rasterised(withoutMarks(text), picture)].map(meanOf),
    };
  });
}

function withoutMarks(svg: string): string {
  return svg.replace(/<g id="marks".*?<\/g>/s, '');
}

/** Mean of all channels, 0 to 255. */
function meanOf({ data }: ImageData): number {
  return data.reduce((sum, value) => sum + value, 0) / data.length;
}

/** Whether the loop of the page is byte for byte what `clip()` gives, of the stage and of what elements answer. */
export function clipped() {
  return untouched(async () => {
    const stage = await lamp();
    const order = { format: 'apng', duration: 0.5, fps: 12, width: WIDTH, height: HEIGHT } as const;
    const remote = { get: async () => stage.get(), save: async () => stage.save() };
    const ofPage = await base64Of(await captured({ rate: 12, seconds: 0.5, hasBackground: false, format: 'apng' }));
    const [own, asked] = [await base64Of(await clip(stage, order)), await base64Of(await clip(remote, order))];
    return { own: own === ofPage, asked: asked === ofPage };
  });
}

/** Cancels a clip after its second frame. */
export function cancelled(format: Format) {
  return untouched(async () => {
    const controller = new AbortController();
    let shares = 0;
    const onProgress = () => void (++shares === 2 && controller.abort());
    const task = { signal: controller.signal, onProgress };
    const outcome = await capture(await lamp(), { ...PLAIN, format, seconds: 5 }, task).then(
      () => 'finished',
      (error: Error) => error.name,
    );
    return { outcome, shares };
  });
}

/** The error of a browser that encodes a PNG in place of a WebP. */
export function withoutWebp() {
  return untouched(async () => {
    const { convertToBlob } = OffscreenCanvas.prototype;
    OffscreenCanvas.prototype.convertToBlob = function () {
      return convertToBlob.call(this, { type: 'image/png' });
    };
    const message = await captured({ format: 'webp' }).catch((error: Error) => `${error.name}: ${error.message}`);
    OffscreenCanvas.prototype.convertToBlob = convertToBlob;
    return { message };
  });
}

/** What is compared, by format. */
export function compared(settings: Partial<CaptureSettings>, isWithoutEncoder = false) {
  return untouched(async () => {
    const encoder = globalThis.VideoEncoder;
    if (isWithoutEncoder) Reflect.deleteProperty(globalThis, 'VideoEncoder');
    const shares: number[] = [];
    const task = { signal: new AbortController().signal, onProgress: (share: number) => void shares.push(share) };
    const found = await compareFormats(await lamp(), { ...PLAIN, ...settings }, task);
    globalThis.VideoEncoder = encoder;
    const rows = found.map(({ format, file, note }) => [format, file?.type, note]);
    return { rows, sizes: found.map(({ file }) => file?.size ?? Infinity), shares };
  });
}

/** Header of a HEVC stream without parameter sets. */
const HVCC = Uint8Array.of(
  1,
  1,
  0x60,
  0,
  0,
  0,
  0x90,
  0,
  0,
  0,
  0,
  0,
  153,
  0xf0,
  0,
  0xfc,
  0xfd,
  0xf8,
  0xf8,
  0,
  0,
  0x0f,
  0,
);

/** Records what it is given, and has one byte for each frame. */
class FakeEncoder extends EventTarget {
  static configs: VideoEncoderConfig[] = [];
  static corners: number[] = [];
  state: CodecState = 'configured';
  readonly encodeQueueSize = 0;
  private readonly init: VideoEncoderInit;
  constructor(init: VideoEncoderInit) {
    super();
    this.init = init;
  }
  static isConfigSupported(config: VideoEncoderConfig) {
    return Promise.resolve({ supported: config.alpha === 'keep' && config.codec.startsWith('hvc1'), config });
  }
  configure(config: VideoEncoderConfig) {
    FakeEncoder.configs.push(config);
  }
  encode(frame: VideoFrame, { keyFrame }: VideoEncoderEncodeOptions = {}) {
    FakeEncoder.corners.push(drawn(frame, WIDTH, HEIGHT).data[3]);
    const { timestamp, duration } = frame;
    const chunk = { type: keyFrame ? 'key' : 'delta', timestamp, duration: duration!, data: Uint8Array.of(1) } as const;
    const decoderConfig = { codec: 'hvc1.1.6.L153.B0', codedWidth: WIDTH, codedHeight: HEIGHT, description: HVCC };
    this.init.output(new EncodedVideoChunk(chunk), { decoderConfig });
  }
  flush() {
    return Promise.resolve();
  }
  close() {
    this.state = 'closed';
  }
}

/** MP4 with alpha by an encoder that has it, and the field of the background with and without such an encoder. */
export function hevc() {
  return untouched(async () => {
    const encoder = globalThis.VideoEncoder;
    const hasField: boolean[] = [];
    const form = new SettingsForm();
    const ask = async () => {
      for (const format of ['png', 'mp4']) {
        form.element.querySelector<HTMLSelectElement>('[name=format]')!.value = format;
        form.element.dispatchEvent(new Event('input'));
        // The form has asked before, and has its answer before.
        await hevcWithAlpha({ width: WIDTH, height: HEIGHT, rate: 24 });
        await new Promise((resolve) => setTimeout(resolve));
      }
      const field = form.element.querySelector<HTMLInputElement>('[name=background]')!;
      field.checked = false;
      hasField.push(!field.disabled, form.settings().hasBackground);
    };
    await ask();
    globalThis.VideoEncoder = FakeEncoder as unknown as typeof VideoEncoder;
    await ask();
    const blob = await captured({ format: 'mp4', hasBackground: false });
    globalThis.VideoEncoder = encoder;
    const input = new Input({ source: new BlobSource(blob), formats: ALL_FORMATS });
    const track = (await input.getPrimaryVideoTrack())!;
    const times: number[] = [];
    for await (const { timestamp } of new EncodedPacketSink(track).packets()) times.push(timestamp);
    const { configs, corners } = FakeEncoder;
    return { hasField, configs, corners, times, codec: track.codec, type: blob.type };
  });
}

/** The error without an encoder. */
export function withoutEncoder() {
  return untouched(async () => {
    const encoder = globalThis.VideoEncoder;
    Reflect.deleteProperty(globalThis, 'VideoEncoder');
    const message = await captured({ format: 'mp4' }).catch((error: Error) => `${error.name}: ${error.message}`);
    globalThis.VideoEncoder = encoder;
    return { message };
  });
}

async function rasterised(svg: string, { width, height }: { width: number; height: number }): Promise<ImageData> {
  const image = new Image(width, height);
  image.src = `data:image/svg+xml,${encodeURIComponent(svg)}`;
  await image.decode();
  return drawn(image, width, height);
}

async function pixelsOf(blob: Blob): Promise<ImageData> {
  const bitmap = await createImageBitmap(blob);
  return drawn(bitmap, bitmap.width, bitmap.height);
}

function pixelsOfBytes(bytes: Uint8Array): Promise<ImageData> {
  return pixelsOf(new Blob([bytes.slice()]));
}

function pixelsOfFrame(frame: VideoFrame): ImageData {
  const pixels = drawn(frame, frame.displayWidth, frame.displayHeight);
  frame.close();
  return pixels;
}

function drawn(source: CanvasImageSource, width: number, height: number): ImageData {
  const context = new OffscreenCanvas(width, height).getContext('2d')!;
  context.drawImage(source, 0, 0, width, height);
  return context.getImageData(0, 0, width, height);
}

async function bytesOf(blob: Blob): Promise<Uint8Array<ArrayBuffer>> {
  return new Uint8Array(await blob.arrayBuffer());
}

/** The most frequent opaque colours. */
function commonest({ data }: ImageData, count: number): number[] {
  const counts = new Map<number, number>();
  for (const color of new Uint32Array(data.buffer)) {
    if (color >>> 24 === 255) counts.set(color, (counts.get(color) ?? 0) + 1);
  }
  return [...counts.keys()].sort((a, b) => counts.get(b)! - counts.get(a)!).slice(0, count);
}

function hexOf(color: number): string {
  return `#${[0, 8, 16].map((shift) => ((color >>> shift) & 0xff).toString(16).padStart(2, '0')).join('')}`;
}

/** Pixels of which a channel differs by more than `tolerance`. */
function differing(a: ImageData, b: ImageData, tolerance = 0): number {
  let count = 0;
  for (let at = 0; at < a.data.length; at += 4) {
    if ([0, 1, 2, 3].some((channel) => Math.abs(a.data[at + channel] - b.data[at + channel]) > tolerance)) ++count;
  }
  return count;
}

/** Mean difference of a channel, 0 to 255. */
function meanDifference(a: ImageData, b: ImageData): number {
  let sum = 0;
  a.data.forEach((value, at) => (sum += Math.abs(value - b.data[at])));
  return sum / a.data.length;
}
