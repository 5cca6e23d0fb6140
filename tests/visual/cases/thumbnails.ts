/** Pictures of the presets as the gallery of the page shows them. */
import { findPreset, presetValues } from '../../../src/preset/presets.ts';
import { createStage } from '../../../src/stage/stage.ts';

/** Long enough for smoke to fill its column. */
const SECONDS = 6;
/** By scene, where what makes the smoke is gone by then. */
const EARLIER: Readonly<Record<string, number>> = { rocket: 4 };
const [WIDTH, HEIGHT] = [192, 128];
/** Drawn larger and made smaller, so that ink is as fine as in the picture that it stands for. */
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
