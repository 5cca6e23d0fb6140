/** Contact sheets of presets and measures of their tones, for `npm run look`. */
import type { Values } from '../../../src/parameters/parameter.ts';
import { base64, upright, type LabPicture } from '../lab.ts';
import { SceneLab } from '../sceneLab.ts';
import {
  birthsBetween,
  borderOf,
  countCrumbs,
  countSmall,
  flipsBetween,
  NO_SMOKE,
  regionsOf,
  type Tones,
} from './tones.ts';

const [WIDTH, HEIGHT] = [800, 450];
/** Simulated steps of the moments of a sheet, and of a strip's first frame. */
const MOMENTS = [180, 360, 570, 840];
/** Cameras of a sheet: rotations about the scene, radians. */
const AZIMUTHS = [0, 2, -2];
const FRAMES = 12;
/** Steps between the frames of a strip, and between pictures that are compared: 1/30 and 1/20 s are the nearest to 1/24. */
const STEPS_PER_FRAME = 2;
/** Moments that measures are the mean of, two seconds apart. Crumbs are counted between them, too. */
const MEASURED = 8;
const SECOND = 60;
/** Distance within which a region of the frame before is the same region, pixels. */
const REACH = 0;
/** Size of a cell of a sheet, pixels. */
const CELL = [WIDTH / 2, HEIGHT / 2] as const;
/** All particles, as on the page. */
const FULL: Values = { 'simulation.maxParticles': 3000 };

/** Mean measures of a preset's tones at its camera, 800x450. */
export interface ToneMeasures {
  /** Regions of one tone, and those of 4 to 59 pixels. */
  regions: number;
  small: number;
  /** Share of smoke that changes its tone between frames. */
  flips: number;
  /** Regions of more than 12 pixels that appear at once between frames. */
  births: number;
  /** Share of smoke that has its lightest tone. */
  lit: number;
  /** Length of the border between tones, pixels. */
  border: number;
  /** Pieces of the silhouette of 4 to 499 pixels, without the largest piece. */
  crumbs: number;
}

/** Pictures as PNG in base64: moments by cameras, and neighbouring frames. */
export async function sheets(preset: string): Promise<{ sheet: string; strip: string }> {
  const lab = await SceneLab.create(preset, {
    width: WIDTH,
    height: HEIGHT,
    smoothEdges: true,
    ownLook: true,
    ownPuffs: true,
    values: FULL,
  });
  const sheet = new Sheet(AZIMUTHS.length, MOMENTS.length);
  const strip = new Sheet(4, FRAMES / 4);
  const { azimuth } = lab.scene.camera;
  let steps = 0;
  for (const [row, moment] of MOMENTS.entries()) {
    lab.step(moment - steps);
    steps = moment;
    for (const [column, offset] of AZIMUTHS.entries()) {
      sheet.draw(lab.draw({ camera: lab.camera({ azimuth: azimuth + offset }) }), column, row);
    }
  }
  for (let frame = 0; frame < FRAMES; frame++) {
    strip.draw(lab.draw(), frame % 4, Math.floor(frame / 4));
    lab.step(STEPS_PER_FRAME);
  }
  lab.dispose();
  return { sheet: await sheet.png(), strip: await strip.png() };
}

/** @param values override those of the preset */
export async function measureTones(preset: string, values: Values = {}): Promise<ToneMeasures> {
  const plain: Values = { 'style.outlines': 0, 'style.gradient': 'none' };
  const choice = { width: WIDTH, height: HEIGHT, ownLook: true, values: { ...FULL, ...plain, ...values } };
  const lab = await SceneLab.create(preset, choice);
  const sums: ToneMeasures = { regions: 0, small: 0, flips: 0, births: 0, lit: 0, border: 0, crumbs: 0 };
  for (let moment = 0; moment < MEASURED; moment++) {
    lab.step(SECOND);
    sums.crumbs += countCrumbs(tonesOf(lab)) / 2;
    lab.step(SECOND);
    const before = tonesOf(lab);
    sums.crumbs += countCrumbs(before) / 2;
    lab.step(STEPS_PER_FRAME);
    const now = tonesOf(lab);
    const regions = regionsOf(now);
    sums.regions += regions.filter(({ pixels }) => pixels.length > 3).length;
    sums.small += countSmall(regions);
    sums.flips += flipsBetween(before, now);
    sums.births += birthsBetween(before, now, REACH);
    sums.lit += litShare(now);
    sums.border += borderOf(now);
  }
  lab.dispose();
  return Object.fromEntries(
    Object.entries(sums).map(([name, sum]) => [name, sum / MEASURED]),
  ) as unknown as ToneMeasures;
}

/** Pictures side by side, at half size. */
class Sheet {
  private readonly canvas: OffscreenCanvas;

  constructor(columns: number, rows: number) {
    this.canvas = new OffscreenCanvas(columns * CELL[0], rows * CELL[1]);
  }

  draw({ pixels, width, height }: LabPicture, column: number, row: number): void {
    const picture = new OffscreenCanvas(width, height);
    picture.getContext('2d')!.putImageData(upright(pixels, width, height), 0, 0);
    const context = this.canvas.getContext('2d')!;
    context.imageSmoothingQuality = 'high';
    context.drawImage(picture, column * CELL[0], row * CELL[1], ...CELL);
  }

  async png(): Promise<string> {
    return base64(await this.canvas.convertToBlob({ type: 'image/png' }));
  }
}

/** The colours of smoke as tones. Smoke is where its normals are drawn. */
function tonesOf(lab: SceneLab): Tones {
  const { width, height, pixels } = lab.draw();
  const colors = new Int32Array(pixels.slice().buffer);
  const [normals, none] = [false, true].map(
    (isBare) => new Int32Array(lab.draw({ view: 'normals', isBare }).pixels.buffer),
  );
  const tones = colors.map((color, pixel) => (normals[pixel] === none[pixel] ? NO_SMOKE : color & 0xffffff));
  return { width, height, tones };
}

function litShare({ tones }: Tones): number {
  const counts = new Map<number, number>();
  for (const tone of tones) if (tone !== NO_SMOKE) counts.set(tone, (counts.get(tone) ?? 0) + 1);
  const all = [...counts.values()].reduce((sum, count) => sum + count, 0);
  const [lightest] = [...counts]
    .filter(([, count]) => count > 0.02 * all)
    .toSorted(([a], [b]) => lightness(b) - lightness(a));
  return lightest ? lightest[1] / all : 0;
}

function lightness(color: number): number {
  return 0.3 * (color & 255) + 0.59 * ((color >> 8) & 255) + 0.11 * ((color >> 16) & 255);
}
