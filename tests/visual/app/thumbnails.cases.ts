/** Pictures of the presets for the page's gallery. */
import { findPreset, presetValues } from '../../../src/preset/presets.ts';
import { createStage } from '../../../src/stage/stage.ts';

/** Long enough for smoke to fill its column. */
const SECONDS = 6;
/** By scene, where the emitter is out of view at that time. */
const EARLIER: Readonly<Record<string, number>> = { rocket: 4 };
const [WIDTH, HEIGHT] = [192, 128];
/** Drawn at a larger scale and then reduced, so that ink lines are as thin as in the full picture. */
const ENLARGED = 3;
const QUALITY = 0.85;

/** A preset's picture as WebP, base64. */
export async function thumbnail(name: string): Promise<string> {
  const canvas = document.createElement('canvas');
  const [width, height] = [ENLARGED * WIDTH, ENLARGED * HEIGHT];
  const values = presetValues(findPreset(name)!);
  const stage = await createStage(canvas, { values, width, height });
  await stage.seek(EARLIER[values.scene as string] ?? SECONDS);
  const picture = await createImageBitmap(await stage.picture());
  stage.dispose();
  return encode(picture);
}

async function encode(picture: ImageBitmap): Promise<string> {
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [WIDTH, HEIGHT];
  const context = canvas.getContext('2d')!;
  context.imageSmoothingQuality = 'high';
  context.drawImage(picture, 0, 0, WIDTH, HEIGHT);
  return canvas.toDataURL('image/webp', QUALITY).split(',')[1];
}
