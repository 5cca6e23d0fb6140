/** Pictures of the presets for the page: in its gallery, and as posters in place of the stage while it loads. */
import { findPreset, presetValues } from '../../../src/parameters/presets.ts';
import { createStage, type Stage } from '../../../src/stage/stage.ts';

/** Long enough for smoke to fill its column. */
const SECONDS = 6;
/** By scene, where the emitter is out of view or rests at that time. */
const EARLIER: Readonly<Record<string, number>> = { rocket: 4, dragon: 4 };
/** The time of the still frame of `src/demo/main.ts`, which replaces the poster for users who prefer less motion. */
const STILL_SECONDS = 4;

/** The size of a picture in pixels. It is drawn larger, so that ink lines are as thin as in the full picture. */
interface Size {
  readonly width: number;
  readonly height: number;
  readonly enlarged: number;
  readonly quality: number;
}

const THUMBNAIL: Size = { width: 192, height: 128, enlarged: 3, quality: 0.85 };
/** By suffix of the file name. A tall stage has another camera, so it has its own poster. */
const POSTERS: Readonly<Record<string, Size>> = {
  wide: { width: 800, height: 400, enlarged: 2, quality: 0.5 },
  tall: { width: 360, height: 540, enlarged: 1.25, quality: 0.5 },
};

/** Characters of base64 of 30,000 bytes, above which a picture is drawn with less quality. */
const LONGEST = 40_000;

/** A preset's picture as WebP, base64. */
export async function thumbnail(name: string): Promise<string> {
  const stage = await stageOf(name);
  await stage.seek(EARLIER[stage.get().scene as string] ?? SECONDS);
  const picture = await draw(stage, THUMBNAIL);
  stage.dispose();
  return picture;
}

/** A preset's posters as WebP, base64, by suffix of their file names. */
export async function posters(name: string): Promise<Record<string, string>> {
  const stage = await stageOf(name);
  await stage.seek(STILL_SECONDS);
  const made: Record<string, string> = {};
  for (const [suffix, size] of Object.entries(POSTERS)) made[suffix] = await draw(stage, size);
  stage.dispose();
  return made;
}

/** Nothing is drawn before the picture. */
function stageOf(name: string): Promise<Stage> {
  const values = presetValues(findPreset(name)!);
  return createStage(document.createElement('canvas'), { values, visible: false });
}

async function draw(stage: Stage, { width, height, enlarged, quality }: Size): Promise<string> {
  stage.resize(enlarged * width, enlarged * height, 1);
  const picture = await createImageBitmap(await stage.picture());
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [width, height];
  const context = canvas.getContext('2d')!;
  context.imageSmoothingQuality = 'high';
  context.drawImage(picture, 0, 0, width, height);
  const [, encoded] = canvas.toDataURL('image/webp', quality).split(',');
  return encoded.length > LONGEST ? draw(stage, { width, height, enlarged, quality: quality - 0.05 }) : encoded;
}
