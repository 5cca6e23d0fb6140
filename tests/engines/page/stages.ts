/** Runs in a page: stages on the main thread, small because of software rendering. */
import { capture } from '../../../src/demo/capture/capture.ts';
import type { Format } from '../../../src/demo/capture/settings.ts';
import { encode } from '../../../src/parameters/codec.ts';
import { findPreset, presetValues } from '../../../src/parameters/presets.ts';
import type { Values } from '../../../src/parameters/parameter.ts';
import type { PresetName } from '../../../src/parameters/valueTypes.ts';
import { createStage, type Stage } from '../../../src/stage/stage.ts';
import { packed, packedFile } from './bytes.ts';
import { PLAIN_LOOK } from '../../support/plainLook.ts';

const [WIDTH, HEIGHT] = [160, 120];
/** Little smoke of one shape is cheap to bake and draw. */
const LITTLE: Values = { 'simulation.maxParticles': 500, 'puff.variations': 1 };

let shown: Promise<Stage> | undefined;

/**
 * The picture of a preset as a PNG, base64. All pictures share a stage, because each new context compiles its programs
 * again.
 */
export async function pictureOf(name: string, seconds: number, width: number, height: number): Promise<string> {
  const values = presetValues(findPreset(name)!);
  // A hidden stage draws only the requested picture.
  const options = { values, width, height, pixelRatio: 1, visible: false };
  shown ??= createStage(document.createElement('canvas'), options);
  const stage = await shown;
  await stage.enter(values);
  await stage.seek(seconds);
  return packedFile(await stage.picture());
}

function open(preset: string, values = valuesOf(preset)): Promise<Stage> {
  return createStage(document.createElement('canvas'), { values, width: WIDTH, height: HEIGHT, pixelRatio: 1 });
}

function valuesOf(preset: string): Values {
  return { ...presetValues(findPreset(preset)!), ...PLAIN_LOOK, ...LITTLE };
}

/** Simulates user input: drags an object, drops another, blows and steers. */
export async function perform(
  preset: PresetName,
): Promise<{ hash: string; link: string; steps: number; inputs: number }> {
  const stage = await open(preset);
  stage.step(40);
  const { x, y } = handleOf(stage);
  stage.pointer({ type: 'down', id: 1, x, y });
  for (let move = 1; move <= 6; ++move) {
    stage.pointer({ type: 'move', id: 1, x: x - 4 * move, y: y - 2 * move });
    stage.step(5);
  }
  stage.pointer({ type: 'up', id: 1, x, y });
  stage.drop(60, 30);
  stage.step(15);
  stage.blow({ x: 80, y: 60, dx: 6, dy: -3 });
  stage.step(15);
  stage.steer(0, -0.6);
  stage.steer(1, 0.3);
  stage.step(60);
  const link = await encode({ preset, values: stage.get() }, stage.take().toBytes());
  const { steps, inputs } = stage.stats;
  const hash = stage.hash();
  stage.dispose();
  return { hash, link, steps, inputs };
}

/** A position of the picture at which the pointer hits a draggable object. */
function handleOf(stage: Stage): { x: number; y: number } {
  for (let y = 2; y < HEIGHT; y += 4) {
    for (let x = 2; x < WIDTH; x += 4) {
      const taken = stage.pointer({ type: 'down', id: -1, x, y });
      stage.pointer({ type: 'cancel', id: -1, x, y });
      if (taken === 'rigid') return { x, y };
    }
  }
  throw new Error('Nothing in the picture can be dragged.');
}

/** A saved state, its later state, and the later state of another stage that restores it. */
export async function saveAndRestore(preset: string, steps: number) {
  const [stage, other] = [await open(preset), await open(preset)];
  stage.step(90);
  const state = stage.save();
  const saved = stage.hash();
  other.restore(state);
  const restored = other.hash();
  for (const one of [stage, other]) one.step(steps);
  const report = { state: packed(state), values: stage.get(), saved, restored, ends: [stage.hash(), other.hash()] };
  for (const one of [stage, other]) one.dispose();
  return report;
}

/** The capture of the lamp, or its error. */
export async function captured(
  format: Format,
): Promise<{ type: string; bytes: string } | { error: string; message: string }> {
  const stage = await open('lamp');
  stage.step(60);
  const order = {
    format,
    width: 80,
    height: 60,
    scale: 1,
    hasBackground: true,
    seconds: 0.5,
    rate: 12,
    inLayers: false,
  };
  try {
    const file = await capture(stage, order, { signal: new AbortController().signal, onProgress: () => undefined });
    return { type: file.type, bytes: await packedFile(file) };
  } catch (error) {
    return { error: (error as Error).name, message: (error as Error).message };
  } finally {
    stage.dispose();
  }
}
