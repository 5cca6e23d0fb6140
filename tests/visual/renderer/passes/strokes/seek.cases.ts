/** Strokes of a moment that a stage plays to, and of the same moment that it seeks. */
import type { Values } from '../../../../../src/parameters/parameter.ts';
import { findPreset, presetValues } from '../../../../../src/parameters/presets.ts';
import { createStage } from '../../../../../src/stage/stage.ts';
import { PLAIN_LOOK } from '../../../../support/plainLook.ts';
import { pixelsOf } from '../../../stage/stage.cases.ts';

const [WIDTH, HEIGHT] = [480, 270];
const STEPS = 150;
/** Steps that are drawn before and after the moment. */
const DRAWN = 3;

/** Pixels that strokes change, and pixels that differ after playing on and seeking back, and on a stage that only seeks. */
export async function seekToStrokes(): Promise<{ ink: number; back: number; direct: number }> {
  const [played, sought] = [await strokesStage(), await strokesStage()];
  played.step(STEPS - DRAWN);
  for (let step = 0; step < DRAWN; step++) {
    await played.picture();
    played.step(1);
  }
  const picture = await pixelsOf(await played.picture());
  for (let step = 0; step < DRAWN; step++) {
    played.step(1);
    await played.picture();
  }
  await played.seek(STEPS / 60);
  const back = await pixelsOf(await played.picture());
  await sought.seek(STEPS / 60);
  const direct = await pixelsOf(await sought.picture());
  sought.set({ 'style.strokes': 0 });
  const bare = await pixelsOf(await sought.picture());
  for (const stage of [played, sought]) stage.dispose();
  const differing = (other: Uint32Array) => picture.filter((pixel, at) => pixel !== other[at]).length;
  return { ink: differing(bare), back: differing(back), direct: differing(direct) };
}

function strokesStage() {
  const own: Values = {
    'style.strokes': 1,
    'style.outlineWidth': 5,
    'style.boil': 1,
    'style.shadows': 0,
    'simulation.maxParticles': 800,
  };
  const values = { ...presetValues(findPreset('lamp')!), ...PLAIN_LOOK, ...own };
  return createStage(new OffscreenCanvas(WIDTH, HEIGHT), { values, width: WIDTH, height: HEIGHT, pixelRatio: 1 });
}
