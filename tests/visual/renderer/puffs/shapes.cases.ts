/** Puffs with custom shapes: changes of parameters, meshes of the host, several smokes on one device. */
import { createDevice } from '../../../../src/renderer/gpu/device.ts';
import type { AnyValues, Values } from '../../../../src/parameters/parameter.ts';
import { defaultPreset, presetValues } from '../../../../src/parameters/presets.ts';
import { designedShapes } from '../../../../src/renderer/puffs/lobeShapes.ts';
import type { PuffShape } from '../../../../src/renderer/puffs/shapes.ts';
import { bakedPuffs } from '../../../../src/renderer/bakedPuffs.ts';
import { drawFrame } from '../../../../src/renderer/frame.ts';
import { SmokeRenderer } from '../../../../src/renderer/smoke.ts';
import { createStage, type Stage } from '../../../../src/stage/stage.ts';
import { gpuKeepsUp } from '../../../support/gpuKeepsUp.ts';
import { inputOf, type LabScene } from '../../lab.ts';
import { random } from '../../random.ts';
import { PLAIN_LOOK } from '../../../support/plainLook.ts';

const [WIDTH, HEIGHT] = [160, 120];
const VALUES: Values = { ...presetValues(defaultPreset), ...PLAIN_LOOK, 'simulation.maxParticles': 400 };

/** A ring of balls: unlike a puff it has a hole, and parts far behind its centre are visible. */
export const RING: PuffShape = {
  name: 'ring',
  lobes: Array.from({ length: 12 }, (_, index) => {
    const angle = (index / 12) * 2 * Math.PI;
    return { center: [0.72 * Math.cos(angle), 0.72 * Math.sin(angle), 0.1 * (index % 2)], radius: 0.25 };
  }),
};

/** Shapes with minimum, maximum and random parameters, and two that no parameters produce. */
export function oddShapes(): PuffShape[] {
  const next = random(5);
  const shapes = Array.from({ length: 14 }, (_, seed) => {
    const knob = () => (seed < 8 ? Number(next() < 0.5) : next());
    const design = { lumpiness: knob(), flatness: knob(), roughness: knob(), lobes: 5 + (seed % 8), seed };
    return designedShapes(design, 4)[seed % 4];
  });
  return [...shapes, RING, { name: 'ball', lobes: [{ center: [0, 0, 0], radius: 1 }] }];
}

/** Smokes with different puffs on one device: pixels of each that differ after the other has drawn. */
export async function shareDevice(): Promise<{ between: number; disturbed: number; same: number; held: number[] }> {
  const device = createDevice(new OffscreenCanvas(1, 1));
  device.renderer.setSize(WIDTH, HEIGHT, false);
  const scene: LabScene = {
    width: WIDTH,
    height: HEIGHT,
    puffs: [0, 1].map((side) => ({ place: [side - 0.5, 0, 0], radius: 0.6, variation: side, seed: 7 })),
  };
  const smoke = (shapes?: readonly PuffShape[]) =>
    new SmokeRenderer(device, { capacity: 2, puffs: bakedPuffs(shapes) });
  const draw = (drawn: SmokeRenderer): Uint32Array => {
    drawFrame(drawn, inputOf(scene));
    const pixels = new Uint32Array(WIDTH * HEIGHT);
    const gl = device.renderer.getContext();
    gl.readPixels(0, 0, WIDTH, HEIGHT, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(pixels.buffer));
    return pixels;
  };
  const [first, second, third] = [smoke(), smoke([RING]), smoke()];
  const [before, other, after] = [draw(first), draw(second), draw(first)];
  third.setPuffs(bakedPuffs([RING]));
  const same = differing(draw(third), other);
  const held = [device.puffs.lobes.size];
  for (const one of [second, third, first]) {
    one.dispose();
    held.push(device.puffs.lobes.size);
  }
  device.dispose();
  return { between: differing(before, other), disturbed: differing(before, after), same, held };
}

async function stageOf(values: Values = {}, canvas = new OffscreenCanvas(WIDTH, HEIGHT)): Promise<Stage> {
  return createStage(canvas, { values: { ...VALUES, ...values }, width: WIDTH, height: HEIGHT });
}

/**
 * A paused stage whose parameters change: pixels that differ from before, from a stage created with these values, and,
 * after the values are restored, from the first picture.
 */
export async function changeKnobs(values: Values): Promise<{ changed: number; asMade: number; back: number }> {
  const [stage, made] = [await stageOf(), await stageOf(values)];
  for (const each of [stage, made]) each.step(80);
  const before = await pixelsOf(stage);
  const base: AnyValues = stage.get();
  stage.set(values);
  const after = await pixelsOf(stage);
  stage.set(Object.fromEntries(Object.keys(values).map((key) => [key, base[key]])));
  const report = {
    changed: differing(before, after),
    asMade: differing(after, await pixelsOf(made)),
    back: differing(before, await pixelsOf(stage)),
  };
  for (const each of [stage, made]) each.dispose();
  return report;
}

/** Pixels that change when there are fewer variations than living particles use, at once and in a restored state. */
export async function fewerVariations(): Promise<{ atOnce: number; restored: number; later: boolean }> {
  const stage = await stageOf({ 'puff.variations': 9 });
  stage.step(80);
  const before = await pixelsOf(stage);
  stage.set({ 'puff.variations': 2 });
  const atOnce = differing(before, await pixelsOf(stage));
  const other = await stageOf();
  other.restore(stage.save());
  const restored = differing(before, await pixelsOf(other));
  stage.step(60);
  const later = differing(before, await pixelsOf(stage)) > 0;
  for (const each of [stage, other]) each.dispose();
  return { atOnce, restored, later };
}

/** A stage with a custom shape, in both forms, and without it again. */
export async function bringShape(): Promise<{ lobes: number; billboards: number; back: number; hash: boolean }> {
  const stage = await stageOf();
  stage.step(80);
  const hash = stage.hash();
  const first = await pixelsOf(stage);
  stage.setPuffs([RING]);
  const ring = await pixelsOf(stage);
  stage.set({ 'puff.form': 'billboards' });
  const flatRing = await pixelsOf(stage);
  stage.setPuffs();
  const flat = await pixelsOf(stage);
  stage.set({ 'puff.form': 'lobes' });
  const report = {
    lobes: differing(first, ring),
    billboards: differing(flat, flatRing),
    back: differing(first, await pixelsOf(stage)),
    hash: stage.hash() === hash,
  };
  stage.dispose();
  return report;
}

/** Pixels of billboards that 8 bits change, and that 16 bits then leave changed. */
export async function changePrecision(): Promise<{ changed: number; back: number }> {
  const stage = await stageOf({ 'puff.form': 'billboards' });
  stage.step(300);
  const before = await pixelsOf(stage);
  stage.set({ 'puff.precision': 8 });
  const changed = differing(before, await pixelsOf(stage));
  stage.set({ 'puff.precision': 16 });
  const back = differing(before, await pixelsOf(stage));
  stage.dispose();
  return { changed, back };
}

/**
 * Changes a parameter while a stage plays with a stopped clock: the number of frames until the picture changes, and its
 * difference from the picture of a paused stage. Each read of the time advances it by one millisecond, so the result
 * counts frames and does not depend on the machine.
 */
export async function changeWhilePlaying(): Promise<{ frames: number; leftOver: number }> {
  let frame: FrameRequestCallback = () => {};
  gpuKeepsUp();
  const { requestAnimationFrame } = globalThis;
  globalThis.requestAnimationFrame = (callback) => {
    frame = callback;
    return 1;
  };
  const canvas = new OffscreenCanvas(WIDTH, HEIGHT);
  const stage = await stageOf({}, canvas);
  stage.step(80);
  stage.speed = 0;
  stage.play();
  frame(0);
  const before = shown(canvas);
  stage.set({ 'puff.lumpiness': 0.21, 'puff.seed': 77 });
  let looked = 0;
  performance.now = () => looked++;
  const report = { frames: 0, leftOver: 0 };
  while (report.frames < 500 && differing(before, shown(canvas)) === 0) {
    report.frames += 1;
    frame(report.frames * 16);
  }
  Reflect.deleteProperty(performance, 'now');
  const now = shown(canvas);
  stage.pause();
  report.leftOver = differing(now, await pixelsOf(stage));
  stage.dispose();
  globalThis.requestAnimationFrame = requestAnimationFrame;
  return report;
}

async function pixelsOf(stage: Stage): Promise<Uint32Array> {
  return shown(await createImageBitmap(await stage.picture()));
}

function shown(picture: OffscreenCanvas | ImageBitmap): Uint32Array {
  const copy = new OffscreenCanvas(WIDTH, HEIGHT).getContext('2d')!;
  copy.drawImage(picture, 0, 0);
  return new Uint32Array(copy.getImageData(0, 0, WIDTH, HEIGHT).data.buffer);
}

function differing(a: Uint32Array, b: Uint32Array): number {
  return a.reduce((count, pixel, index) => count + (pixel === b[index] ? 0 : 1), 0);
}
