import type { DebugView } from '../../index.ts';
import type { Values } from '../../preset.ts';
import { linear, NOISE } from './pixels.ts';
import { Archive } from './pngSequence.ts';
import { describeLightMaps, LIGHT_FILES, shootLightMaps, type LightMapInfo } from './lightMaps.ts';
import { encodePng } from '../gallery/straightPng.ts';
import { columnsOf, pixelSize, type CaptureSettings } from './settings.ts';
import { Matrix4, Vector4 } from 'three';
import {
  ALL_THAT_LIVES,
  frameCount,
  PixelReader,
  PLACE_FLOATS,
  shootLoop,
  STEP_SECONDS,
  type FrameInput,
  type Studio,
  type Task,
} from '../../internal.ts';

/** Where the frames are in the atlases: rows from the top, each from left to right. */
export interface FlipbookLayout {
  readonly columns: number;
  readonly rows: number;
  readonly frames: number;
  /** Frames per second. The last frame is followed by the first one. */
  readonly rate: number;
  /** Size of a frame and of an atlas in pixels. */
  readonly frame: readonly [width: number, height: number];
  readonly atlas: readonly [width: number, height: number];
  /** Displacement of a full channel of `motion`, as a fraction of the frame's side. */
  readonly motionRange: number;
  /** Files by content. */
  readonly color: string;
  readonly channels: string;
  readonly normals: string;
  readonly motion: string;
  readonly light?: LightMapInfo;
}

const FILES = { color: 'color.png', channels: 'channels.png', normals: 'normals.png', motion: 'motion.png' } as const;

/** The normal towards the viewer. */
const FACING = [128, 128, 255];

/** Encodes a seamless loop as atlases and their layout, in a zip. */
export async function makeFlipbook(studio: Studio, settings: CaptureSettings, task: Task): Promise<Blob> {
  const archive = new Archive();
  for (const [name, file] of await drawFlipbook(studio, settings, task)) await archive.add(name, file);
  return archive.finish();
}

/**
 * Draws a seamless loop. `color` has straight alpha. The `channels` are light in red, rim light in green, nearness in
 * blue and coverage in alpha; light and rim are linear. `normals` are in view space, 0 to 255 for -1 to 1. `motion` is
 * described in motion.ts. Light maps are added if the settings name their layout, see lightMaps.ts.
 * @param columns of the atlases
 * @returns the files by name
 */
export async function drawFlipbook(
  studio: Studio,
  settings: CaptureSettings,
  task: Task,
  columns = columnsOf(frameCount(settings)),
): Promise<[string, Blob][]> {
  const [width, height] = pixelSize(settings);
  const { lights } = settings;
  const frames = frameCount(settings);
  const rows = Math.ceil(frames / columns);
  const atlas = [width * columns, height * rows] as const;
  const layout: FlipbookLayout = {
    columns,
    rows,
    frames,
    rate: settings.rate,
    frame: [width, height],
    atlas,
    motionRange: MOTION_RANGE,
    ...FILES,
    ...(lights && { light: describeLightMaps(lights) }),
  };
  const canvases = Object.values(FILES).map((name) => [name, new OffscreenCanvas(...atlas)] as const);
  // A canvas would lose the light of pixels whose alpha is 0, where nothing glows.
  const lightAtlases = lights ? LIGHT_FILES.map((name) => [name, new ImageData(...atlas)] as const) : [];
  const camera = new MapCamera(studio, width, height);
  const shoot = async (frame: number, drawn: FrameInput): Promise<void> => {
    const motion = new ImageData(drawMotion(drawn, width, height, settings.rate), width, height);
    const maps = [...(await camera.shoot()), motion];
    const [x, y] = [width * (frame % columns), height * Math.floor(frame / columns)];
    canvases.forEach(([, canvas], at) => canvas.getContext('2d')!.putImageData(maps[at], x, y));
    const lightMaps = lights ? shootLightMaps(lights, maps[0], camera.relit) : [];
    lightMaps.forEach((map, at) => insert(map, lightAtlases[at][1], x, y));
  };
  await shootLoop(studio, settings, task, shoot, (input) => camera.change(input));
  const pictures = canvases.map(
    async ([name, canvas]) => [name, await canvas.convertToBlob({ type: 'image/png' })] as [string, Blob],
  );
  const lightPictures = lightAtlases.map(async ([name, pixels]) => [name, await encodePng(pixels)] as [string, Blob]);
  const text = new Blob([JSON.stringify(layout, null, 2)], { type: 'application/json' });
  return [...(await Promise.all([...pictures, ...lightPictures])), ['flipbook.json', text]];
}

/** Copies pixels into an atlas. @param x, y of the upper left corner */
function insert({ data, width, height }: ImageData, atlas: ImageData, x: number, y: number): void {
  for (let row = 0; row < height; ++row) {
    atlas.data.set(data.subarray(4 * width * row, 4 * width * (row + 1)), 4 * ((y + row) * atlas.width + x));
  }
}

/** Draws a frame as colour, channels and normals, and in other light. */
class MapCamera {
  /** Applied to the input of each picture. */
  change: (input: FrameInput) => FrameInput = (input) => input;
  private readonly studio: Studio;
  private readonly reader: PixelReader;

  constructor(studio: Studio, width: number, height: number) {
    this.studio = studio;
    this.reader = new PixelReader(width, height);
  }

  /** In the order of FILES, without motion. */
  async shoot(): Promise<ImageData[]> {
    const { stage, canvas } = this.studio;
    const color = this.reader.read(canvas);
    const channels = this.withStyle({ 'style.outlines': 0, 'style.rim': 0, 'style.smokeColor': '#ffffff' });
    const dark = this.withStyle({ 'style.rimColor': '#000000' });
    const bright = this.withStyle({ 'style.rimColor': '#ffffff' });
    stage.running.showWith({});
    const normals = await this.seen('normals');
    const depth = await this.seen('depth');
    for (let at = 0; at < channels.data.length; at += 4) {
      channels.data[at] = Math.round(255 * linear(channels.data[at + 1]));
      channels.data[at + 1] = Math.round(255 * Math.max(0, linear(bright.data[at + 1]) - linear(dark.data[at + 1])));
      channels.data[at + 2] = depth.data[at];
      channels.data[at + 3] = color.data[at + 3];
      // Smoothed edges and ink cover pixels that no puff does.
      if (normals.data[at + 3] <= NOISE) normals.data.set(FACING, at);
      normals.data[at + 3] = color.data[at + 3];
    }
    return [color, channels, normals];
  }

  /** Draws the frame once with a changed input. */
  readonly relit = (change: (input: FrameInput) => FrameInput): ImageData => {
    const { change: before } = this;
    this.change = change;
    const pixels = this.withStyle({});
    this.change = before;
    return pixels;
  };

  private withStyle(values: Values): ImageData {
    this.studio.stage.running.showWith(values);
    return this.reader.read(this.studio.canvas);
  }

  private async seen(view: DebugView): Promise<ImageData> {
    const { stage, canvas } = this.studio;
    stage.view = view;
    await stage.complete();
    const pixels = this.reader.read(canvas);
    stage.view = undefined;
    return pixels;
  }
}

/** Displacement of a full channel, as a fraction of the frame's side. */
export const MOTION_RANGE = 0.125;

/** Puffs reach beyond their radius, and ink beyond puffs. Pixels up to this many radii away move like the nearest puff. */
const REACH = 1.6;

/** Colour of no motion. */
const STILL = [128, 128, 0, 255];

/** Added to the depth of pixels outside a puff's radius, so that every puff within its radius covers them. */
const OUTSIDE = 1e6;

/**
 * Draws motion vectors of the smoke: the displacement of each pixel until the next frame, as a fraction of the frame's
 * sides. Red is x to the right, green is y up, 0 to 255 for -{@link MOTION_RANGE} to {@link MOTION_RANGE}. All pixels
 * are opaque; those without smoke do not move. Neither the camera nor objects have motion vectors.
 * @param width, height in pixels
 * @param rate frames per second
 * @returns four bytes per pixel, rows from the top
 */
export function drawMotion(
  input: Pick<FrameInput, 'simulator' | 'camera' | 'blend'>,
  width: number,
  height: number,
  rate: number,
): Uint8ClampedArray<ArrayBuffer> {
  const pixels = new Uint8ClampedArray(4 * width * height);
  for (let at = 0; at < pixels.length; at += 4) pixels.set(STILL, at);
  const nearest = new Float32Array(width * height).fill(Infinity);
  const { rows } = input.simulator.arrange({ ...ALL_THAT_LIVES, blend: input.blend });
  const moves = input.simulator.moves();
  const clipFromWorld = new Matrix4().multiplyMatrices(input.camera.projectionMatrix, input.camera.matrixWorldInverse);
  const [xOfRadius, yOfRadius] = [input.camera.projectionMatrix.elements[0], input.camera.projectionMatrix.elements[5]];
  const scale = 1 / (STEP_SECONDS * rate);
  for (let row = 0; row < rows.count; ++row) {
    const [x, y, z, radius] = rows.place.subarray(PLACE_FLOATS * row);
    const [dx, dy, dz] = moves.subarray(3 * row);
    const here = new Vector4(x, y, z, 1).applyMatrix4(clipFromWorld);
    const next = new Vector4(x + dx * scale, y + dy * scale, z + dz * scale, 1).applyMatrix4(clipFromWorld);
    if (here.w <= 0 || next.w <= 0 || radius === 0) continue;
    const red = channel((next.x / next.w - here.x / here.w) / 2);
    const green = channel((next.y / next.w - here.y / here.w) / 2);
    const [centreX, centreY] = [((1 + here.x / here.w) * width) / 2, ((1 - here.y / here.w) * height) / 2];
    const [radiusX, radiusY] = [(xOfRadius * radius * width) / 2 / here.w, (yOfRadius * radius * height) / 2 / here.w];
    const [top, bottom] = within(centreY, REACH * radiusY, height);
    const [left, right] = within(centreX, REACH * radiusX, width);
    for (let pixelY = top; pixelY <= bottom; ++pixelY) {
      const v = ((pixelY + 0.5 - centreY) / radiusY) ** 2;
      for (let pixelX = left; pixelX <= right; ++pixelX) {
        const squared = v + ((pixelX + 0.5 - centreX) / radiusX) ** 2;
        if (squared > REACH ** 2) continue;
        const depth = squared <= 1 ? here.w - radius * Math.sqrt(1 - squared) : OUTSIDE + radius * Math.sqrt(squared);
        const at = pixelY * width + pixelX;
        if (depth >= nearest[at]) continue;
        nearest[at] = depth;
        pixels[4 * at] = red;
        pixels[4 * at + 1] = green;
      }
    }
  }
  return pixels;
}

function channel(displacement: number): number {
  return Math.round(127.5 * (1 + Math.min(1, Math.max(-1, displacement / MOTION_RANGE))));
}

/** First and last pixel of a span, within a picture. */
function within(centre: number, reach: number, size: number): [number, number] {
  return [Math.max(0, Math.floor(centre - reach)), Math.min(size - 1, Math.ceil(centre + reach))];
}
