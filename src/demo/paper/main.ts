/**
 * The page about the paper. It renders the paper's figures with the library on an offscreen canvas, once with the
 * paper's method and once with ours.
 */
import { createStage, type Stage } from '../../index.ts';
import {
  bakePuffs,
  billboardShapes,
  channelSheet,
  LOBE_SHAPES,
  lobeSheet,
  type ChannelPicture,
} from '../../internal.ts';
import { encode, findPreset, presetValues, type Values } from '../../preset.ts';
import { create } from '../ui/dom.ts';
import { createErrorScreen } from '../ui/errorScreen.ts';
import { PLAIN_LOOK } from './plainLook.ts';

interface Means {
  readonly id: 'paper' | 'ours';
  readonly title: string;
  readonly values: Values;
}

const MEANS: readonly Means[] = [
  {
    id: 'paper',
    title: "The paper's method",
    values: {
      ...PLAIN_LOOK,
      'puff.form': 'billboards',
      'puff.precision': 8,
      'simulation.integrator': 'paper',
      // In the paper, puffs spawn at full size and shrink from there, at a constant rate.
      'emission.growthTime': 0,
      'emission.density': '0:1,1:0',
      'emission.entrainment': 0,
      'emission.company': 0,
      'emission.sizeSpread': 0,
      'style.volumes': 'counted',
      'style.inkSwell': 0,
      'style.innerTaper': 0,
      'style.boil': 0,
    },
  },
  { id: 'ours', title: 'Our method', values: PLAIN_LOOK },
];
/** Simulated seconds of each figure: the smoke has filled its column, and the airplane is among the clouds. */
const MOMENTS = { lamp: 6, 'airplane-corkscrew': 4.5 };
/** Narrow windows use smaller images to reduce the work. */
const isNarrow = matchMedia('(max-width: 640px)').matches;
const SIZE = { width: isNarrow ? 400 : 640, height: isNarrow ? 300 : 480, pixelRatio: 1 };
const TILE = isNarrow ? 64 : 96;
/** Half the width of a tile, in puff radii. */
const PAD = 1.2;
/** Rotation of the lobes that are intersected per pixel (figure 3), in radians. */
const ROLL = 0.7;
const CHANNEL_NAMES: Readonly<Record<string, string>> = { N: 'Normals', d: 'Depth', C: 'Colour', coverage: 'Coverage' };
const RAMPS = [
  { tones: 1, name: 'Monochrome' },
  { tones: 2, name: 'Two-tone' },
  { tones: 3, name: 'Three-tone' },
] as const;
const DRAWN = MEANS.length * (1 + RAMPS.length);

const progress = document.querySelector<HTMLProgressElement>('#progress progress')!;

async function drawFigures(): Promise<void> {
  for (const figure of ['figure-1', 'figure-2', 'figure-3', 'figure-13']) prepare(figure);
  progress.max = DRAWN;
  const maps = bakePuffs(billboardShapes(LOBE_SHAPES), { precision: 8 });
  show('figure-3', 'paper', ...channelSheet(maps, TILE).map(channelCanvas));
  show('figure-3', 'ours', ...lobeSheet(LOBE_SHAPES, ROLL, PAD, TILE).map(channelCanvas));
  const [paper, ours] = MEANS;
  await link('figure-3', paper, 'lamp', {});
  await link('figure-3', ours, 'lamp', {});
  for (const means of MEANS) await drawLamp(means);
  for (const means of MEANS) await drawAirplane(means);
}

/** Figures 1 and 13. They show the same smoke, and both contain the three-tone image. */
async function drawLamp(means: Means): Promise<void> {
  const how = means.title.toLowerCase();
  await onStage('lamp', means, async (stage) => {
    for (const { tones, name } of RAMPS) {
      stage.set({ 'style.tones': tones });
      const image = await picture(stage, `${name} smoke of the lamp, ${how}`);
      if (tones === 3) {
        const large = image.cloneNode() as HTMLImageElement;
        large.alt = `A magic oil lamp with a column of cartoon smoke in three tones, ${how}`;
        show('figure-1', means.id, large);
        await link('figure-1', means, 'lamp', { 'style.tones': 3 });
      }
      show('figure-13', means.id, image);
    }
    await link('figure-13', means, 'lamp', {});
  });
}

async function drawAirplane({ values, ...means }: Means): Promise<void> {
  // Clouds that shrink at a constant rate would be too small at the airplane.
  const lasting: Values = means.id === 'paper' ? { ...values, 'emission.lifetime': 11.2 } : values;
  const shown = { ...means, values: lasting };
  await onStage('airplane-corkscrew', shown, async (stage) => {
    const alt = `A biplane flies through cartoon clouds and winds ribbons of smoke, ${means.title.toLowerCase()}`;
    show('figure-2', means.id, await picture(stage, alt));
    await link('figure-2', shown, 'airplane-corkscrew', {});
  });
}

async function onStage(
  preset: keyof typeof MOMENTS,
  { values }: Means,
  draw: (stage: Stage) => Promise<void>,
): Promise<void> {
  // WebKitGTK does not support WebGL on an OffscreenCanvas.
  const canvas = create('canvas');
  const stage = await createStage(canvas, { ...SIZE, values: { ...presetValues(findPreset(preset)!), ...values } });
  try {
    await stage.seek(MOMENTS[preset]);
    await draw(stage);
  } finally {
    stage.dispose();
  }
}

async function picture(stage: Stage, alt: string): Promise<HTMLImageElement> {
  const address = URL.createObjectURL(await stage.picture());
  const image = create('img', { src: address, alt, width: SIZE.width, height: SIZE.height });
  await image.decode();
  progress.value += 1;
  return image;
}

function channelCanvas({ name, size, pixels }: ChannelPicture): HTMLElement {
  const canvas = create('canvas', { width: size, height: size, role: 'img', 'aria-label': CHANNEL_NAMES[name] });
  canvas.getContext('2d')!.putImageData(new ImageData(pixels, size, size), 0, 0);
  return create('div', { class: 'channel' }, canvas, create('span', { 'aria-hidden': 'true' }, CHANNEL_NAMES[name]));
}

/** Creates both columns of a figure in advance, to avoid layout shifts. */
function prepare(figure: string): void {
  const columns = MEANS.map(({ id, title }) =>
    create('section', { class: id }, create('h3', {}, title), create('div', { class: 'pictures' })),
  );
  document.querySelector(`#${figure} .pair`)!.append(...columns);
}

function show(figure: string, means: Means['id'], ...pictures: HTMLElement[]): void {
  document.querySelector(`#${figure} .${means} .pictures`)!.append(...pictures);
}

/** Adds a link that opens a column's smoke in the demo at the same simulated time. */
async function link(figure: string, { id, values, title }: Means, preset: keyof typeof MOMENTS, more: Values) {
  const state = { preset, values: { ...presetValues(findPreset(preset)!), ...values, ...more } };
  const href = `./?t=${MOMENTS[preset]}${await encode(state)}`;
  const words = create('a', { href, 'aria-label': `Open in the demo, ${title.toLowerCase()}` }, 'Open in the demo');
  document.querySelector(`#${figure} .${id}`)!.append(words);
}

try {
  await drawFigures();
  document.querySelector('#progress')!.remove();
} catch (error) {
  document.querySelector('#progress')!.replaceWith(createErrorScreen(error));
}
