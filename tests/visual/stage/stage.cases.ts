/** Stages as a page creates them, and the pixels of their canvases. Shared by all cases of stages. */
import { createDevice, type Device } from '../../../src/renderer/gpu/device.ts';
import type { Values } from '../../../src/parameters/parameter.ts';
import { defaultPreset, findPreset, presetValues } from '../../../src/parameters/presets.ts';
import { createStage, type Stage } from '../../../src/stage/stage.ts';
import { PLAIN_LOOK } from '../../support/plainLook.ts';

export const [WIDTH, HEIGHT] = [320, 240];

/** Few enough particles for a software renderer. */
export const SMALL: Values = { ...presetValues(defaultPreset), ...PLAIN_LOOK, 'simulation.maxParticles': 800 };

export async function lampStage(canvas: OffscreenCanvas | HTMLCanvasElement, device?: Device): Promise<Stage> {
  return createStage(canvas, { values: SMALL, width: WIDTH, height: HEIGHT, pixelRatio: 1, device });
}

export async function lampPicture(seconds: number): Promise<Blob> {
  const stage = await lampStage(new OffscreenCanvas(WIDTH, HEIGHT));
  await stage.seek(seconds);
  const picture = await stage.picture();
  stage.dispose();
  return picture;
}

/** Colours of a picture, and the pixels of the most frequent one: a blank picture has a single colour. */
export async function census(picture: Blob): Promise<{ colors: number; commonest: number; pixels: number }> {
  const data = await pixelsOf(picture);
  const counts = new Map<number, number>();
  for (const pixel of data) counts.set(pixel, (counts.get(pixel) ?? 0) + 1);
  return { colors: counts.size, commonest: Math.max(...counts.values()), pixels: data.length };
}

/** Metres per CSS pixel of the open-air scene at several device pixel ratios, before and after another scene. */
export async function airPerPixel(): Promise<number[]> {
  const values = { ...presetValues(findPreset('air')!), ...PLAIN_LOOK, 'simulation.maxParticles': 100 };
  const metres: number[] = [];
  for (const pixelRatio of [0.5, 1, 2]) {
    const stage = await createStage(new OffscreenCanvas(WIDTH, HEIGHT), {
      values,
      width: WIDTH,
      height: HEIGHT,
      pixelRatio,
    });
    metres.push(stage.sight.plane.up[1]);
    await stage.enter({ ...values, scene: 'wisp' });
    await stage.enter(values);
    metres.push(stage.sight.plane.up[1]);
    stage.dispose();
  }
  return metres;
}

/** Number of pictures that a stage has drawn: created hidden, visible, resized to the same size, resized to another. */
export async function picturesDrawn(): Promise<number[]> {
  const canvas = new OffscreenCanvas(WIDTH, HEIGHT);
  const size = { width: WIDTH, height: HEIGHT, pixelRatio: 1 };
  const stage = await createStage(canvas, { ...size, values: SMALL, visible: false });
  let drawn = stage.stats.renderMs > 0 ? 1 : 0;
  stage.on('frame', () => (drawn += 1));
  const counts = [drawn];
  const act = (action: () => void) => {
    action();
    counts.push(drawn);
  };
  act(() => (stage.visible = true));
  act(() => stage.resize(WIDTH, HEIGHT, 1));
  act(() => stage.resize(WIDTH / 2, HEIGHT, 1));
  stage.dispose();
  return counts;
}

/** Textures of a device whose stage is visible, hidden, and visible again, and pixels that differ from never hidden. */
export async function hiddenStage(): Promise<{ textures: number[]; differing: number }> {
  const device = createDevice(new OffscreenCanvas(1, 1));
  const stage = await lampStage(new OffscreenCanvas(WIDTH, HEIGHT), device);
  const { memory } = device.renderer.info;
  stage.step(60);
  const before = await stage.picture();
  const textures = [memory.textures];
  stage.visible = false;
  textures.push(memory.textures);
  stage.visible = true;
  stage.step(1);
  await stage.seek(1);
  textures.push(memory.textures);
  const after = await stage.picture();
  stage.dispose();
  device.dispose();
  return { textures, differing: differing(await pixelsOf(before), await pixelsOf(after)) };
}

export function visibleCanvas(): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  canvas.width = WIDTH;
  canvas.height = HEIGHT;
  document.body.append(canvas);
  return canvas;
}

export function shown(canvas: HTMLCanvasElement, width = WIDTH, height = HEIGHT): Uint32Array {
  const copy = new OffscreenCanvas(width, height).getContext('2d')!;
  copy.drawImage(canvas, 0, 0);
  return new Uint32Array(copy.getImageData(0, 0, width, height).data.buffer);
}

export async function pixelsOf(picture: Blob): Promise<Uint32Array> {
  const bitmap = await createImageBitmap(picture);
  const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d')!;
  context.drawImage(bitmap, 0, 0);
  return new Uint32Array(context.getImageData(0, 0, bitmap.width, bitmap.height).data.buffer);
}

export function differing(a: Uint32Array, b: Uint32Array): number {
  return a.reduce((count, pixel, index) => count + (pixel === b[index] ? 0 : 1), 0);
}
