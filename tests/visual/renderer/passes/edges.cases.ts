/**
 * The edge filter on synthetic pictures (two tones on the sides of a straight line, thin lines, a disc on the page) and
 * on a picture of puffs. For synthetic pictures the expected value is the area of each pixel beyond the line.
 */
import {
  DataTexture,
  NearestFilter,
  PerspectiveCamera,
  RGBAFormat,
  UnsignedByteType,
  WebGLRenderTarget,
  type Texture,
} from 'three';
import edgesShader from '../../../../shaders/resolve/edges.frag';
import type { PuffForm } from '../../../../src/renderer/gpu/puffTextures.ts';
import { createDevice } from '../../../../src/renderer/gpu/device.ts';
import { FullScreen } from '../../../../src/renderer/gpu/fullScreen.ts';
import { FrameView } from '../../../../src/renderer/gpu/frameView.ts';
import { ResolvePass } from '../../../../src/renderer/passes/resolve.ts';
import { styleUniforms } from '../../../../src/renderer/style.ts';
import { PLAIN_STYLE, takePicture, type LabScene } from '../../lab.ts';
import { fitDevice, keepPrograms, pageDevice } from '../../pageDevice.ts';
import { random } from '../../random.ts';
import { ground } from '../../solids.ts';

const SIZE = 64;
/** The filter has only one side of a pixel at the border of the picture. */
const MARGIN = 14;

type Tone = readonly [red: number, green: number, blue: number, alpha: number];

/** A pixel in both colour targets: unlit with the alpha of the page, lit with the mask. */
interface Pixel {
  unlit: Tone;
  lit: Tone;
}

const opaque = (red: number, green: number, blue: number): Pixel => ({
  unlit: [red, green, blue, 255],
  lit: [red, green, blue, 0],
});

const SMOKE: Pixel = { unlit: [145, 129, 174, 255], lit: [246, 239, 226, 0] };

/** The colours on the two sides of each edge type. */
const KINDS: Readonly<Record<string, readonly [Pixel, Pixel]>> = {
  ink: [opaque(29, 23, 32), SMOKE],
  shade: [opaque(145, 129, 174), SMOKE],
  shadow: [SMOKE, { unlit: SMOKE.unlit, lit: [246, 239, 226, 255] }],
  seam: [opaque(240, 138, 93), opaque(127, 178, 229)],
  silhouette: [SMOKE, { unlit: [0, 0, 0, 0], lit: [0, 0, 0, 0] }],
  hue: [opaque(44, 20, 20), opaque(20, 20, 44)],
};

/** Signed distance of a pixel centre from a line, pixels. */
type Distance = (x: number, y: number) => number;

/** @param angle in degrees from the horizontal */
function lineAt(angle: number, shift: number): Distance {
  const [normalX, normalY] = [-Math.sin((angle * Math.PI) / 180), Math.cos((angle * Math.PI) / 180)];
  return (x, y) => (x + 0.5 - SIZE / 2) * normalX + (y + 0.5 - SIZE / 2) * normalY - shift;
}

/** Applies the filter to given colours. */
class Filter {
  private readonly device = pageDevice();
  private readonly pass = new ResolvePass(new FrameView(styleUniforms()));
  private readonly output = new WebGLRenderTarget(SIZE, SIZE, { depthBuffer: false });

  /** @returns RGBA bytes, premultiplied, the row y = 0 first; undefined where the picture is drawn to the canvas */
  draw(
    pixelAt: (x: number, y: number) => Pixel,
    smoothEdges: boolean,
    output: WebGLRenderTarget | null = this.output,
  ): Uint8Array {
    const [unlit, lit] = (['unlit', 'lit'] as const).map((color) => textureOf((x, y) => pixelAt(x, y)[color]));
    this.pass.smoothEdges = smoothEdges;
    this.pass.draw(this.device.renderer, { unlit, lit, width: SIZE, height: SIZE }, output);
    keepPrograms(this.device.renderer);
    const pixels = new Uint8Array(4 * SIZE * SIZE);
    if (output) this.device.renderer.readRenderTargetPixels(output, 0, 0, SIZE, SIZE, pixels);
    for (const texture of [unlit, lit]) texture.dispose();
    return pixels;
  }

  /** Shows the filtered picture of the latest colours on a canvas of the page. */
  show(pixelAt: (x: number, y: number) => Pixel, canvas: HTMLCanvasElement): void {
    fitDevice(this.device, SIZE, SIZE);
    this.draw(pixelAt, true, null);
    const picture = (this.device.canvas as OffscreenCanvas).transferToImageBitmap();
    canvas.getContext('bitmaprenderer')!.transferFromImageBitmap(picture);
  }

  dispose(): void {
    this.pass.dispose();
    this.output.dispose();
  }
}

function textureOf(toneAt: (x: number, y: number) => Tone): Texture {
  const data = new Uint8Array(4 * SIZE * SIZE);
  eachPixel(0, (x, y) => data.set(toneAt(x, y), 4 * (y * SIZE + x)));
  const texture = new DataTexture(data, SIZE, SIZE, RGBAFormat, UnsignedByteType);
  texture.minFilter = NearestFilter;
  texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}

function eachPixel(margin: number, visit: (x: number, y: number) => void): void {
  for (let y = margin; y < SIZE - margin; ++y) for (let x = margin; x < SIZE - margin; ++x) visit(x, y);
}

export interface SlantReport {
  /** Distinct colours between those of the two sides. */
  levels: number;
  /**
   * Mean over the pixels on the line: difference between their share of the far colour and their area beyond the line.
   */
  error: number;
  /** The same error without the filter. */
  rawError: number;
  /** Pixels that change although their neighbourhood is flat. */
  flatChanged: number;
  /** Pixels that are not a mixture of the two sides. */
  strange: number;
}

/** A slanted line of each edge type at several angles and offsets. */
export function slants(angles: readonly number[]): { kind: string; angle: number; report: SlantReport }[] {
  const filter = new Filter();
  const reports = Object.entries(KINDS).flatMap(([kind, sides]) =>
    angles.map((angle) => ({ kind, angle, report: slantAt(filter, sides, angle) })),
  );
  filter.dispose();
  return reports;
}

function slantAt(filter: Filter, [near, far]: readonly [Pixel, Pixel], angle: number): SlantReport {
  const colors = new Set<string>();
  const report = { levels: 0, error: 0, rawError: 0, flatChanged: 0, strange: 0 };
  let crossed = 0;
  for (const shift of [0.1, 0.35, 0.6, 0.85]) {
    const distance = lineAt(angle, shift);
    const pixelAt = (x: number, y: number) => (distance(x, y) > 0 ? far : near);
    const [raw, smooth] = [false, true].map((smoothEdges) => filter.draw(pixelAt, smoothEdges));
    const [from, to] = [colorOf(raw, far, pixelAt), colorOf(raw, near, pixelAt)];
    eachPixel(MARGIN, (x, y) => {
      const at = 4 * (y * SIZE + x);
      const color = smooth.subarray(at, at + 4);
      const share = shareBetween(to, from, color);
      if (Math.abs(distance(x, y)) > 2.2 && color.some((value, channel) => value !== raw[at + channel])) {
        report.flatChanged += 1;
      }
      if (!isMixture(to, from, color)) report.strange += 1;
      if (share > 0.02 && share < 0.98) colors.add(color.join());
      const area = areaBeyond(distance, x, y);
      if (area <= 0 || area >= 1) return;
      crossed += 1;
      report.error += Math.abs(share - area);
      report.rawError += Math.abs((distance(x, y) > 0 ? 1 : 0) - area);
    });
  }
  return { ...report, levels: colors.size, error: report.error / crossed, rawError: report.rawError / crossed };
}

function colorOf(pixels: Uint8Array, side: Pixel, pixelAt: (x: number, y: number) => Pixel): Uint8Array {
  for (let y = 0; y < SIZE; ++y) {
    for (let x = 0; x < SIZE; ++x) {
      if (pixelAt(x, y) === side) return pixels.slice(4 * (y * SIZE + x), 4 * (y * SIZE + x) + 4);
    }
  }
  throw new RangeError('The line leaves no pixel on one of its sides.');
}

/** Linear light of an 8-bit sRGB value, 0 to 1. */
function light(value: number): number {
  const display = value / 255;
  return display <= 0.04045 ? display / 12.92 : ((display + 0.055) / 1.055) ** 2.4;
}

/** The values that the filter mixes: linear light times alpha, and alpha. */
function amounts(color: Uint8Array): number[] {
  const alpha = color[3] / 255;
  const own = (value: number) => (alpha > 0 ? light(Math.min(255, value / alpha)) * alpha : 0);
  return [own(color[0]), own(color[1]), own(color[2]), alpha];
}

/** The share of `to` in a mixture, from the channel with the largest difference between `from` and `to`. */
function shareBetween(from: Uint8Array, to: Uint8Array, color: Uint8Array): number {
  const [a, b, c] = [amounts(from), amounts(to), amounts(color)];
  const gaps = a.map((value, channel) => Math.abs(b[channel] - value));
  const channel = gaps.indexOf(Math.max(...gaps));
  return (c[channel] - a[channel]) / (b[channel] - a[channel]);
}

function isMixture(from: Uint8Array, to: Uint8Array, color: Uint8Array): boolean {
  const share = shareBetween(from, to, color);
  const [a, b, c] = [amounts(from), amounts(to), amounts(color)];
  return c.every((value, channel) => Math.abs(a[channel] + share * (b[channel] - a[channel]) - value) < 0.012);
}

/** The part of a pixel beyond a line, from 16 x 16 samples. */
function areaBeyond(distance: Distance, x: number, y: number): number {
  if (Math.abs(distance(x, y)) > 0.75) return distance(x, y) > 0 ? 1 : 0;
  let beyond = 0;
  for (let point = 0; point < 256; ++point) {
    const [dx, dy] = [((point % 16) + 0.5) / 16 - 0.5, (Math.floor(point / 16) + 0.5) / 16 - 0.5];
    if (distance(x + dx, y + dy) > 0) beyond += 1;
  }
  return beyond / 256;
}

interface LineReport {
  /** Darkness after the filter divided by the darkness before. */
  kept: number;
  /** The same for the four-pixel segment with the largest loss. */
  palest: number;
}

/** Dark lines on a light ground: straight lines at several angles, and a ring. Widths in pixels. */
export function thinLines(
  widths: readonly number[],
  angles: readonly (number | 'ring')[],
): { width: number; angle: number | 'ring'; report: LineReport }[] {
  const filter = new Filter();
  const reports = widths.flatMap((width) =>
    angles.map((angle) => ({ width, angle, report: lineReport(filter, width, angle) })),
  );
  filter.dispose();
  return reports;
}

function lineReport(filter: Filter, width: number, angle: number | 'ring'): LineReport {
  const straight = lineAt(angle === 'ring' ? 0 : angle, 0.2);
  const distance: Distance =
    angle === 'ring' ? (x, y) => Math.hypot(x + 0.5 - SIZE / 2 - 0.2, y + 0.5 - SIZE / 2 - 0.1) - 17.3 : straight;
  const pixelAt = (x: number, y: number) => (Math.abs(distance(x, y)) <= width / 2 ? KINDS.ink[0] : KINDS.ink[1]);
  const [raw, smooth] = [false, true].map((smoothEdges) => darkness(filter.draw(pixelAt, smoothEdges)));
  const around =
    angle === 'ring'
      ? sumsOfSectors
      : Math.abs(Math.cos((angle * Math.PI) / 180)) >= Math.SQRT1_2
        ? sumsOfColumns
        : sumsOfRows;
  const [before, after] = [around(raw), around(smooth)];
  const sum = (values: readonly number[]) => values.reduce((total, value) => total + value, 0);
  const stretch = (values: readonly number[], from: number) => sum(values.slice(from, from + 4));
  const palest = before.slice(3).map((_, from) => stretch(after, from) / stretch(before, from));
  return { kept: sum(after) / sum(before), palest: Math.min(...palest) };
}

/** Linear light of the ground minus that of each pixel. */
function darkness(pixels: Uint8Array): Float64Array {
  const background = light(KINDS.ink[1].lit[0]);
  return Float64Array.from({ length: SIZE * SIZE }, (_, pixel) => 1 - light(pixels[4 * pixel]) / background);
}

function sumsOfColumns(values: Float64Array): number[] {
  return between((column) => over((row) => values[row * SIZE + column]));
}

function sumsOfRows(values: Float64Array): number[] {
  return between((row) => over((column) => values[row * SIZE + column]));
}

/** Sums over 48 sectors around the centre. */
function sumsOfSectors(values: Float64Array): number[] {
  const sums = Array<number>(48).fill(0);
  eachPixel(0, (x, y) => {
    const fraction = Math.atan2(y + 0.5 - SIZE / 2, x + 0.5 - SIZE / 2) / (2 * Math.PI) + 0.5;
    sums[Math.min(47, Math.floor(48 * fraction))] += values[y * SIZE + x];
  });
  return sums;
}

function between(sumAt: (index: number) => number): number[] {
  return Array.from({ length: SIZE - 2 * MARGIN }, (_, index) => sumAt(MARGIN + index));
}

function over(valueAt: (index: number) => number): number {
  return Array.from({ length: SIZE }, (_, index) => valueAt(index)).reduce((sum, value) => sum + value, 0);
}

/** Number of pixels that change at the corner of an axis-aligned square. */
export function corner(): number {
  const filter = new Filter();
  const pixelAt = (x: number, y: number) => (x < SIZE / 2 && y < SIZE / 2 ? KINDS.ink[0] : KINDS.ink[1]);
  const [raw, smooth] = [false, true].map((smoothEdges) => filter.draw(pixelAt, smoothEdges));
  filter.dispose();
  return raw.filter((value, index) => value !== smooth[index]).length;
}

/**
 * Pixels that differ between the resolve pass and the edge filter over the whole picture, pixels that the filter changes,
 * and tiles that are filtered, for a picture of slanted bands.
 * @param width, height pixels
 * @param slope difference of neighbouring pixels in a band, 0 to 255
 * @param hasBands whether neighbouring bands differ
 */
export function tiled(
  width: number,
  height: number,
  slope: number,
  hasBands: boolean,
): { different: number; filtered: number; marked: number } {
  const device = createDevice(new OffscreenCanvas(1, 1));
  const pass = new ResolvePass(new FrameView(styleUniforms()));
  const [unlit, lit] = [255, 0].map((alpha) => bands(width, height, alpha, slope, hasBands));
  const draw = (drawInto: (target: WebGLRenderTarget) => void) => {
    const target = new WebGLRenderTarget(width, height, { depthBuffer: false, magFilter: NearestFilter });
    drawInto(target);
    const pixels = new Uint8Array(4 * width * height);
    device.renderer.readRenderTargetPixels(target, 0, 0, width, height, pixels);
    return { target, pixels: new Uint32Array(pixels.buffer) };
  };
  const resolved = (smoothEdges: boolean) =>
    draw((target) => {
      pass.smoothEdges = smoothEdges;
      pass.draw(device.renderer, { unlit, lit, width, height }, target);
    });
  const tones = resolved(false);
  const filter = new FullScreen(edgesShader, { tones: { value: tones.target.texture } });
  const expected = draw((target) => {
    device.renderer.setRenderTarget(target);
    filter.draw(device.renderer);
  });
  const actual = resolved(true);
  const differences = (other: Uint32Array) => expected.pixels.filter((pixel, at) => pixel !== other[at]).length;
  const tiles = pass['marks'];
  const marked = new Uint8Array(4 * tiles.width * tiles.height);
  device.renderer.readRenderTargetPixels(tiles, 0, 0, tiles.width, tiles.height, marked);
  const report = {
    different: differences(actual.pixels),
    filtered: differences(tones.pixels),
    marked: marked.filter((value, at) => at % 4 === 0 && value > 0).length,
  };
  for (const part of [unlit, lit, tones.target, expected.target, actual.target, filter, pass, device]) part.dispose();
  return report;
}

/** Slanted bands, whose edges follow the borders of tiles and bend there. */
function bands(width: number, height: number, alpha: number, slope: number, hasBands: boolean): Texture {
  const data = new Uint8Array(4 * width * height);
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      const band = hasBands ? Math.floor((y + Math.floor(x / 8)) / 8) : 0;
      const blue = Math.abs(((slope * (x + y)) % 400) - 200);
      data.set([60 * (band % 4), 120 * (band % 2), blue, alpha], 4 * (y * width + x));
    }
  }
  const texture = new DataTexture(data, width, height, RGBAFormat, UnsignedByteType);
  texture.needsUpdate = true;
  return texture;
}

const PAGE = KINDS.silhouette[1];

/** An inked disc on a page, which is transparent by default. */
function disc(page: Pixel = PAGE): (x: number, y: number) => Pixel {
  return (x, y) => {
    const radius = Math.hypot(x + 0.5 - SIZE / 2 - 0.3, y + 0.5 - SIZE / 2 + 0.2);
    return radius > 21.5 ? page : radius > 19 ? KINDS.ink[0] : SMOKE;
  };
}

/**
 * The smoothed outline of a disc on a transparent page and on an opaque grey page: the largest difference of a pixel's
 * page share between the two, and the number of pixels that are neither page nor disc.
 */
export function pageShares(grey: number): { farthest: number; mixed: number } {
  const filter = new Filter();
  const [clear, filled] = [disc(), disc(opaque(grey, grey, grey))].map((pixelAt) => filter.draw(pixelAt, true));
  filter.dispose();
  const ink = Uint8Array.from(KINDS.ink[0].unlit);
  const report = { farthest: 0, mixed: 0 };
  for (let at = 0; at < clear.length; at += 4) {
    const alpha = clear[at + 3] / 255;
    if (alpha === 0 || alpha === 1) continue;
    report.mixed += 1;
    const share = shareBetween(ink, Uint8Array.of(grey, grey, grey, 255), filled.subarray(at, at + 4));
    report.farthest = Math.max(report.farthest, Math.abs(1 - alpha - share));
  }
  return report;
}

/**
 * Shows the smoothed disc on the page in front of a photograph-like background.
 * @returns both as RGBA bytes, top row first
 */
export function showDisc(background: string): { disc: number[]; behind: number[] } {
  const filter = new Filter();
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [SIZE, SIZE];
  const behind = background === 'noise' ? noise() : undefined;
  document.body.replaceChildren(canvas);
  document.body.style.cssText = `margin:0;background:${behind ? `url(${behind.url})` : background}`;
  canvas.style.display = 'block';
  filter.show(disc(), canvas);
  // The filter is not disposed before the page: disposal of its context would also clear the canvas.
  const pixels = filter.draw(disc(), true);
  const stride = 4 * SIZE;
  const flipped = Array.from({ length: 4 * SIZE * SIZE }, (_, at) => {
    const row = SIZE - 1 - Math.floor(at / stride);
    return pixels[row * stride + (at % stride)];
  });
  const grey = background === 'white' ? 255 : 0;
  const plain = Array.from({ length: 4 * SIZE * SIZE }, (_, index) => (index % 4 === 3 ? 255 : grey));
  return { disc: flipped, behind: behind?.pixels ?? plain };
}

function noise(): { url: string; pixels: number[] } {
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [SIZE, SIZE];
  const context = canvas.getContext('2d')!;
  const image = context.createImageData(SIZE, SIZE);
  const next = random(11);
  image.data.forEach((_, index) => (image.data[index] = index % 4 === 3 ? 255 : Math.floor(256 * next())));
  context.putImageData(image, 0, 0);
  return { url: canvas.toDataURL(), pixels: [...image.data] };
}

export interface SceneReport {
  /** Distinct colours between two flat colours along all their edges, by the pair. */
  levels: Record<string, number>;
  /** Pixels whose 3 x 3 neighbourhood has one colour, and those of them that change. */
  flat: number;
  flatChanged: number;
  /** Changed pixels that are not a mixture of their own colour and a neighbour's. */
  strange: number;
}

/**
 * Two puffs, one in front of the other, on a ground and a transparent page: every edge type that the passes produce.
 */
export function sceneEdges(form: PuffForm, outlines: boolean): SceneReport {
  const [width, height] = [320, 240];
  const scene: LabScene = {
    width,
    height,
    puffs: [
      { place: [-0.35, 0.35, 0.2], radius: 0.6, seed: 3 },
      { place: [0.45, 0.15, -0.3], radius: 0.7, seed: 9, variation: 1 },
    ],
    surfaces: [ground(-0.9, 1.6)],
    camera: tiltedCamera(width / height),
    towardsLight: [-0.5, 0.8, 0.4],
    style: { form, outlines },
  };
  const [raw, smooth] = [false, true].map((smoothEdges) => takePicture({ ...scene, smoothEdges }).pixels);
  const levels = new Map<string, Set<string>>();
  const report = { levels: {}, flat: 0, flatChanged: 0, strange: 0 };
  const colorAt = (pixels: Uint8Array, pixel: number) => pixels.subarray(4 * pixel, 4 * pixel + 4);
  for (let pixel = width + 1; pixel < width * (height - 1) - 1; ++pixel) {
    const [own, now] = [colorAt(raw, pixel), colorAt(smooth, pixel)];
    const hasChanged = own.join() !== now.join();
    const around = [-width - 1, -width, 1 - width, -1, 1, width - 1, width, width + 1].map((by) =>
      colorAt(raw, pixel + by),
    );
    if (around.every((color) => color.join() === own.join())) {
      report.flat += 1;
      report.flatChanged += hasChanged ? 1 : 0;
    }
    if (!hasChanged) continue;
    const other = around.find((color) => color.join() !== own.join() && isMixture(own, color, now));
    if (!other) report.strange += 1;
    const names = [own, other ?? own]
      .map((color) => nameOf(color))
      .sort()
      .join(' on ');
    levels.set(names, (levels.get(names) ?? new Set()).add(now.join()));
  }
  return { ...report, levels: Object.fromEntries([...levels].map(([names, colors]) => [names, colors.size])) };
}

function tiltedCamera(aspect: number): PerspectiveCamera {
  const camera = new PerspectiveCamera(40, aspect, 0.1, 50);
  camera.position.set(0, 1.1, 4);
  camera.lookAt(0, -0.1, 0);
  camera.updateMatrixWorld();
  return camera;
}

/** Name of a flat colour of `sceneEdges`. Brightness distinguishes the tones of ground and smoke. */
function nameOf(color: Uint8Array): string {
  if (color[3] === 0) return 'page';
  const { inkColor, smokeColor } = PLAIN_STYLE;
  if (inkColor.every((value, channel) => value === color[channel])) return 'ink';
  if (smokeColor.every((value, channel) => value === color[channel])) return 'light';
  if (color[0] > color[2]) return color[0] > 200 ? 'ground' : 'shadow';
  return 'shade';
}

/** Marks of a few pixels by position, and whether a pen stroke could produce them. */
const MARKS: Readonly<Record<string, { pixels: readonly string[]; isDrawn: boolean }>> = {
  'a pixel': { pixels: ['30 30'], isDrawn: false },
  'a pair': { pixels: ['30 30', '31 30'], isDrawn: false },
  'a slanted pair': { pixels: ['30 30', '31 31'], isDrawn: false },
  'dots in a row': { pixels: ['30 30', '32 30', '34 31', '36 31'], isDrawn: false },
  'a stroke': { pixels: ['30 30', '31 30', '32 30'], isDrawn: true },
  'a slanted stroke': { pixels: ['30 30', '31 31', '32 32'], isDrawn: true },
};

/** The share of each mark's darkness on a light ground that remains after the filter. */
export function marks(): { name: string; isDrawn: boolean; left: number }[] {
  const filter = new Filter();
  const reports = Object.entries(MARKS).map(([name, { pixels, isDrawn }]) => {
    const pixelAt = (x: number, y: number) => KINDS.ink[pixels.includes(`${x} ${y}`) ? 0 : 1];
    const [before, after] = [false, true].map((smoothEdges) =>
      darkness(filter.draw(pixelAt, smoothEdges)).reduce((sum, value) => sum + value, 0),
    );
    return { name, isDrawn, left: after / before };
  });
  filter.dispose();
  return reports;
}
