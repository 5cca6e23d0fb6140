/** Puff sheets as PNG files. Loaded with the first one. */
import {
  designedShapes,
  drawPuff,
  readPuffSheet,
  ShapeError,
  writePuffSheet,
  type PixelImage,
  type PuffShape,
  type Stage,
} from '../../index.ts';
import { designOf } from '../../internal.ts';
import { download } from '../ui/dom.ts';
import { decodePng, encodePng } from './straightPng.ts';

/** Puffs of a sheet. */
const MAX_PUFFS = 4;
/** Pixels that are looked at to find the normals. */
const PROBES = 20_000;
/** Minimum share of them whose colour is a unit vector, in an image of normals; and its deviation from the unit. */
const SHARE_OF_NORMALS = 0.8;
const UNIT_TOLERANCE = 0.08;

/**
 * Reads the puffs of a sheet: of one file with light, rim, depth and mask, or of two in any order, with normals and
 * depths, and with colours and coverage.
 * @throws ShapeError with what is wrong and what to do
 */
export async function openSheet(files: readonly File[], signal?: AbortSignal): Promise<PuffShape[]> {
  if (files.length > 2) throw new ShapeError(`A puff sheet has one or two images, not ${files.length}.`);
  const images: PixelImage[] = [];
  for (const file of files) {
    images.push(await decodePng(file));
    signal?.throwIfAborted();
  }
  const shares = images.map(shareOfNormals);
  const normals = shares.indexOf(Math.max(...shares));
  const hasNormals = shares[normals] >= SHARE_OF_NORMALS;
  const [name] = files[0].name.split(/\.\w+$/);
  if (images.length === 1 && hasNormals) {
    throw new ShapeError(
      `${files[0].name} has normals and depths. Open it together with the image of colours and coverage.`,
    );
  }
  if (images.length === 1) return readPuffSheet({ lightRimDepthMask: images[0] }, { name, signal });
  if (!hasNormals) {
    throw new ShapeError('Neither of the two images has normals: their red, green and blue must be unit vectors.');
  }
  return readPuffSheet({ normalDepth: images[normals], colorCoverage: images[1 - normals] }, { name, signal });
}

/** The share of an image whose colours are unit vectors; black is no colour. */
function shareOfNormals({ width, height, data }: PixelImage): number {
  const stride = 4 * Math.max(1, Math.floor((width * height) / PROBES));
  let [units, colors] = [0, 0];
  for (let at = 0; at < data.length; at += stride) {
    const [red, green, blue] = [data[at], data[at + 1], data[at + 2]];
    if (red + green + blue === 0) continue;
    colors++;
    const length = Math.hypot(red - 127.5, green - 127.5, blue - 127.5) / 127.5;
    if (Math.abs(length - 1) < UNIT_TOLERANCE) units++;
  }
  return colors > 0 ? units / colors : 0;
}

/**
 * Downloads the two images of the first four shapes.
 * @param own shapes of the user; without them, those that the values of the stage describe
 * @returns the number of shapes that are saved, and of all
 */
export async function saveSheet(
  stage: Stage,
  own: readonly PuffShape[] | undefined,
  signal?: AbortSignal,
): Promise<{ saved: number; all: number }> {
  const values = stage.get();
  const drawn = values['puff.drawing'] ? values['puff.drawing'].split(';').map((text) => drawPuff(text)) : undefined;
  const shapes = own ?? drawn ?? designedShapes(designOf(values), values['puff.variations']!);
  const saved = shapes.slice(0, MAX_PUFFS);
  const { normalDepth, colorCoverage } = await writePuffSheet(saved, { signal });
  const images = [await encodePng(normalDepth), await encodePng(colorCoverage)];
  signal?.throwIfAborted();
  download('puffs-normal-depth.png', images[0]);
  download('puffs-color-coverage.png', images[1]);
  return { saved: saved.length, all: shapes.length };
}
