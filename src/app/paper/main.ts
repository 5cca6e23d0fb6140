/** The page about the paper: draws its figures with the library, one after the other, on a canvas that nobody sees. */
import { presetValues, defaultPreset } from '../../preset/presets.ts';
import { bakePuffs } from '../../puffs/layers.ts';
import { channelSheet, type ChannelPicture } from '../../puffs/channelSheet.ts';
import { PUFF_SHAPES } from '../../puffs/shapes.ts';
import { createStage, type Stage } from '../../stage/stage.ts';
import { create } from '../dom.ts';
import { createRefusal } from '../refusal.ts';

/** Simulated seconds, by which the smoke fills its column. */
const MOMENT = 6;
const SIZE = { width: 720, height: 540, pixelRatio: 1 };
const TILE = 96;
const CHANNEL_NAMES: Readonly<Record<string, string>> = { N: 'Normals', d: 'Depth', C: 'Colour', coverage: 'Coverage' };
const RAMPS = [
  { tones: 1, name: 'Monochrome' },
  { tones: 2, name: 'Two-tone' },
  { tones: 3, name: 'Three-tone' },
] as const;

async function drawFigures(): Promise<void> {
  const channels = channelSheet(bakePuffs(PUFF_SHAPES), TILE);
  show('figure-3', ...channels.map(channelCanvas));
  const stage = await createStage(new OffscreenCanvas(1, 1), { ...SIZE, values: presetValues(defaultPreset) });
  try {
    await stage.seek(MOMENT);
    show('figure-1', await picture(stage, 3, 'A magic oil lamp with cartoon smoke in three tones'));
    for (const { tones, name } of RAMPS) show('figure-13', await picture(stage, tones, `${name} smoke`));
  } finally {
    stage.dispose();
  }
}

async function picture(stage: Stage, tones: number, description: string): Promise<HTMLImageElement> {
  stage.set({ 'style.tones': tones });
  const address = URL.createObjectURL(await stage.picture());
  const image = create('img', { src: address, alt: description, width: SIZE.width, height: SIZE.height });
  await image.decode();
  URL.revokeObjectURL(address);
  return image;
}

function channelCanvas({ name, size, pixels }: ChannelPicture): HTMLCanvasElement {
  const canvas = create('canvas', { width: size, height: size, role: 'img', 'aria-label': CHANNEL_NAMES[name] });
  canvas.getContext('2d')!.putImageData(new ImageData(pixels, size, size), 0, 0);
  return canvas;
}

function show(figure: string, ...pictures: HTMLElement[]): void {
  document.querySelector(`#${figure} .pictures`)!.append(...pictures);
}

try {
  await drawFigures();
  document.querySelector('#progress')!.remove();
} catch (error) {
  document.querySelector('#progress')!.replaceWith(createRefusal(error));
}
