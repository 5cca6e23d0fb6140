/** Pictures of single parameters for the documentation, drawn by `npm run build`. */
import { findPreset, presetValues } from '../../../src/parameters/presets.ts';
import type { Value, Values } from '../../../src/parameters/parameter.ts';
import { createStage, type Stage } from '../../../src/stage/stage.ts';

/** Values besides those of the preset. */
interface Picture {
  readonly values: Readonly<Record<string, number | string>>;
}

const PRESET = 'lamp';
const SECONDS = 4;
/** Pixels. It is drawn larger, so that lines are as thin as in a full picture. */
const SIZE = { width: 192, height: 128 };
const ENLARGED = 2;
const QUALITY = 0.8;
/** Enough for all values but the largest rates, which would take long. */
const CAPACITY = 1500;
/** Groups that change the picture only. */
const OF_PICTURE = /^(style|light)\./;

/** @returns WebP as base64, in the order given */
export async function draw(pictures: readonly Picture[], say: (line: string) => Promise<void>): Promise<string[]> {
  const base = { ...presetValues(findPreset(PRESET)!), 'simulation.maxParticles': CAPACITY };
  const stage = await createStage(document.createElement('canvas'), { values: base, visible: false });
  stage.resize(ENLARGED * SIZE.width, ENLARGED * SIZE.height, 1);
  await stage.seek(SECONDS);
  const made: string[] = [];
  const known = new Map<string, string>();
  const steady = pictures.filter(isOfPicture);
  for (const picture of [...steady, ...pictures.filter((each) => !isOfPicture(each))]) {
    const values = JSON.stringify(picture.values);
    await say(`${known.size}: ${values}`);
    known.set(values, known.get(values) ?? (await drawOne(stage, base, picture)));
  }
  for (const { values } of pictures) made.push(known.get(JSON.stringify(values))!);
  stage.dispose();
  return made;
}

function isOfPicture({ values }: Picture): boolean {
  return Object.keys(values).every((key) => OF_PICTURE.test(key));
}

async function drawOne(stage: Stage, base: Values, picture: Picture): Promise<string> {
  const values = picture.values as Readonly<Record<string, Value>>;
  const before = stage.get() as Readonly<Record<string, Value>>;
  if (isOfPicture(picture)) stage.set(values);
  else {
    await stage.enter({ ...base, ...values });
    await stage.seek(SECONDS);
  }
  await stage.complete();
  const text = await encoded(await stage.picture());
  if (isOfPicture(picture)) {
    const keys = Object.keys(values);
    stage.set(Object.fromEntries(keys.filter((key) => key in before).map((key) => [key, before[key]])));
    stage.unset(keys.filter((key) => !(key in before)));
  }
  return text;
}

async function encoded(png: Blob): Promise<string> {
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [SIZE.width, SIZE.height];
  const context = canvas.getContext('2d')!;
  context.imageSmoothingQuality = 'high';
  context.drawImage(await createImageBitmap(png), 0, 0, SIZE.width, SIZE.height);
  return canvas.toDataURL('image/webp', QUALITY).replace(/^.*,/, '');
}
