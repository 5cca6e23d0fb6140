/** Pictures of the presets as the gallery of the page shows them. */
import { findPreset, presetValues } from '../../../src/preset/presets.ts';
import { createStage } from '../../../src/stage/stage.ts';

/** Long enough for smoke to fill its column, and short enough for what comes and goes not to be gone. */
const SECONDS = 6;
const [WIDTH, HEIGHT] = [192, 128];
/** Drawn larger and made smaller, so that ink is as fine as in the picture that it stands for. */
const ENLARGED = 3;
const QUALITY = 0.85;

/** A preset's picture as WebP, base64. */
export async function thumbnail(name: string): Promise<string> {
  const canvas = document.createElement('canvas');
  const [width, height] = [ENLARGED * WIDTH, ENLARGED * HEIGHT];
  const stage = await createStage(canvas, { values: presetValues(findPreset(name)!), width, height });
  await stage.seek(SECONDS);
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
