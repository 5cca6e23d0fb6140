import type { DebugView } from '../../index.ts';
import type { Values } from '../../preset.ts';
import type { Task } from './clip.ts';
import { shootLoop } from './loop.ts';
import { drawMotion, MOTION_RANGE } from './motion.ts';
import { linear, NOISE, PixelReader } from './pixels.ts';
import { Archive } from './pngSequence.ts';
import { columnsOf, frameCount, pixelSize, type CaptureSettings } from './settings.ts';
import type { Studio } from './studio.ts';

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
 * described in motion.ts.
 * @param columns of the atlases
 * @returns the files by name
 */
export async function drawFlipbook(
  studio: Studio,
  settings: CaptureSettings,
  task: Task,
  columns = columnsOf(settings),
): Promise<[string, Blob][]> {
  const [width, height] = pixelSize(settings);
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
  };
  const canvases = Object.values(FILES).map((name) => [name, new OffscreenCanvas(...atlas)] as const);
  const camera = new MapCamera(studio, width, height);
  await shootLoop(studio, settings, task, async (frame, drawn) => {
    const motion = new ImageData(drawMotion(drawn, width, height, settings.rate), width, height);
    const maps = [...(await camera.shoot()), motion];
    const [x, y] = [width * (frame % columns), height * Math.floor(frame / columns)];
    canvases.forEach(([, canvas], at) => canvas.getContext('2d')!.putImageData(maps[at], x, y));
  });
  const pictures = canvases.map(
    async ([name, canvas]) => [name, await canvas.convertToBlob({ type: 'image/png' })] as [string, Blob],
  );
  const text = new Blob([JSON.stringify(layout, null, 2)], { type: 'application/json' });
  return [...(await Promise.all(pictures)), ['flipbook.json', text]];
}

/** Draws a frame as colour, channels and normals. */
class MapCamera {
  private readonly studio: Studio;
  private readonly reader: PixelReader;
  private readonly style: Values;

  constructor(studio: Studio, width: number, height: number) {
    this.studio = studio;
    this.reader = new PixelReader(width, height);
    this.style = studio.stage.get();
  }

  /** In the order of FILES, without motion. */
  async shoot(): Promise<ImageData[]> {
    const { stage, canvas } = this.studio;
    const color = this.reader.read(canvas);
    const channels = this.withStyle({ 'style.outlines': 0, 'style.rim': 0, 'style.smokeColor': '#ffffff' });
    const dark = this.withStyle({ 'style.rimColor': '#000000' });
    const bright = this.withStyle({ 'style.rimColor': '#ffffff' });
    stage.set(this.ownStyle());
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

  private withStyle(values: Values): ImageData {
    this.studio.stage.set({ ...this.ownStyle(), ...values });
    return this.reader.read(this.studio.canvas);
  }

  /** The values that the maps change. */
  private ownStyle(): Values {
    const keys = ['style.outlines', 'style.rim', 'style.rimColor', 'style.smokeColor'] as const;
    return Object.fromEntries(keys.map((key) => [key, this.style[key]]));
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
