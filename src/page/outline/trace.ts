/** Traces texts, pictures and meshes to outlines, on a grid of SIDE pixels along the longer side. */
import { ParameterError, ShapeError } from '../../base/errors.ts';
import { MAX_LAYERS, OUTLINE_LIMIT } from '../../base/outlineText.ts';
import { SIDE, type Line } from '../../renderer/puffs/drawing/drawing.ts';
import type { PlainMesh } from '../../renderer/puffs/fit/closedMesh.ts';
import { writeOutline } from './outline.ts';
import { areaOf, ringsOf, simplified } from './rings.ts';
import { pictureOfSvg, type Picture } from './svg.ts';

/** What a shape is traced from: one of these. */
export interface ShapeSource {
  /** At most 40 characters. Line breaks start new lines. */
  readonly text?: string;
  /** Font of the text, as in CSS but without a size; heavy letters hold more smoke. The font must be loaded. */
  readonly font?: string;
  /** Data of an SVG path, as in the attribute `d`. */
  readonly path?: string;
  /** The text of an SVG file. Of it, only the geometry of basic shapes is used: nothing is requested. */
  readonly svg?: string;
  /** What it covers by more than half, by its alpha, is in the shape. */
  readonly image?: ImageBitmapSource;
  /** Closed. It is cut into layers along z; its front is at the greatest z. */
  readonly mesh?: PlainMesh;
}

/** Pixels that a shape fills along its longer side. */
const FILLED = SIDE - 4;
const MAX_TEXT = 40;
/** Additional space between letters, relative to the size of the font. */
const SPACING = 0.08;
const MAX_PATH = 100_000;
const MAX_PIXELS = 8192;
/** Layers of a mesh. */
const LAYERS = 6;
/** Deviation in units with which tracing begins, and its growth while the text is too long. */
const FIRST_TOLERANCE = 0.6;
const GROWTH = 1.25;

/** See `traceShape`. */
export async function outlineOf(source: ShapeSource): Promise<string> {
  const { text, font = '900 system-ui, sans-serif', path, svg, image, mesh } = source;
  if (text !== undefined) return outlineOfPicture(pictureOfText(text, font));
  if (path !== undefined) return outlineOfPicture(pictureOfPath(path));
  if (svg !== undefined) return outlineOfPicture(pictureOfSvg(svg));
  if (image !== undefined) return outlineOfPicture(await pictureOfImage(image));
  if (mesh !== undefined) return outlineOfMasks(masksOfMesh(mesh));
  throw new ParameterError('traceShape', source, 'one of text, path, svg, image and mesh');
}

/** @throws ShapeError if the picture covers nothing */
export function outlineOfPicture(picture: Picture): string {
  return outlineOfMasks([maskOfPicture(picture)]);
}

/**
 * Writes the outline of layers.
 * @param masks from back to front, SIDE rows of SIDE pixels each, empty at the border
 */
function outlineOfMasks(masks: readonly Uint8Array[]): string {
  const layers = masks.map(ringsOf);
  const all = layers.flat();
  if (all.length === 0) throw new ShapeError('The shape is empty: there is nothing to fill with smoke.');
  const largest = Math.max(...all.map(areaOf));
  for (let tolerance = FIRST_TOLERANCE; ; tolerance *= GROWTH) {
    const least = Math.min(4 * tolerance ** 2, largest);
    const kept = layers.map((rings) => rings.filter((ring) => areaOf(ring) >= least));
    const text = writeOutline(kept.map((rings) => rings.map((ring) => closed(ring, tolerance))));
    if (text.length <= OUTLINE_LIMIT) return text;
  }
}

/** Outlines close themselves. */
function closed(ring: Line, tolerance: number): Line {
  return simplified(ring, tolerance).slice(0, -1);
}

function pictureOfText(text: string, font: string): Picture {
  if (typeof text !== 'string' || text.trim() === '' || text.length > MAX_TEXT)
    throw new ParameterError('traceShape.text', text, `1 to ${MAX_TEXT} characters`);
  const lines = text.split('\n');
  const size = 100;
  // Words before the family, such as the weight, come before the size.
  const [, style, family] = /^((?:[\w-]+ )*?)((?:[^\s,]+|"[^"]*")(?:,.*)?)$/.exec(font.trim()) ?? [];
  if (family === undefined) throw new ParameterError('traceShape.font', font, 'a font such as 900 Arial, sans-serif');
  const set = (context: OffscreenCanvasRenderingContext2D): void => {
    context.font = `${style}${size}px ${family}`;
    context.textAlign = 'center';
    // Puffs are wider than their places: letters keep apart.
    context.letterSpacing = `${SPACING * size}px`;
  };
  const context = new OffscreenCanvas(1, 1).getContext('2d')!;
  set(context);
  const width = Math.max(...lines.map((line) => context.measureText(line).width)) + size;
  return {
    box: [-width / 2, -1.5 * size, width, (lines.length + 1) * size],
    draw(into) {
      set(into);
      for (const [index, line] of lines.entries()) into.fillText(line, 0, index * size);
    },
  };
}

function pictureOfPath(path: string): Picture {
  if (typeof path !== 'string' || path.length > MAX_PATH)
    throw new ParameterError('traceShape.path', path, `at most ${MAX_PATH} characters`);
  // Paths have any place and size: a first drawing finds them.
  const own = new Path2D(path);
  const numbers = (path.match(/[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?/gi) ?? []).map(Number).filter(Number.isFinite);
  const reach = Math.max(1, ...numbers.map(Math.abs)) * 2;
  return {
    box: [-reach, -reach, 2 * reach, 2 * reach],
    // oxlint-disable-next-line unicorn/no-array-fill-with-reference-type -- a canvas is no array
    draw: (context) => context.fill(own),
  };
}

async function pictureOfImage(image: ImageBitmapSource): Promise<Picture> {
  const bitmap = await createImageBitmap(image).catch((error: unknown) => {
    throw new ShapeError('The image cannot be read. It must be a loaded picture.', { cause: error });
  });
  const { width, height } = bitmap;
  if (Math.max(width, height) > MAX_PIXELS)
    throw new ShapeError(`The image has ${width} x ${height} pixels. The limit is ${MAX_PIXELS} on a side.`);
  return { box: [0, 0, width, height], draw: (context) => context.drawImage(bitmap, 0, 0) };
}

/** Where a place of the source is on the grid: scaled, then moved. */
type Fit = readonly [scale: number, x: number, y: number];

/** Draws a picture again and again, larger, until it just fits on the grid. */
function maskOfPicture(picture: Picture): Uint8Array {
  const [x, y, width, height] = picture.box;
  const context = new OffscreenCanvas(SIDE, SIDE).getContext('2d', { willReadFrequently: true })!;
  let fit = fitOf([x, x + width], [y, y + height]);
  for (let round = 0; ; round++) {
    const [scale, moveX, moveY] = fit;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, SIDE, SIDE);
    context.setTransform(scale, 0, 0, scale, moveX, moveY);
    picture.draw(context);
    const { data } = context.getImageData(0, 0, SIDE, SIDE);
    // The border stays empty.
    const isInner = (at: number): boolean =>
      at % SIDE > 0 && at % SIDE < SIDE - 1 && at > SIDE && at < SIDE * (SIDE - 1);
    const mask = Uint8Array.from({ length: SIDE * SIDE }, (_, at) => (data[4 * at + 3] > 127 && isInner(at) ? 1 : 0));
    const [columns, rows] = extentOf(mask);
    if (!(columns[1] > columns[0])) throw new ShapeError('The shape is empty: there is nothing to fill with smoke.');
    const size = Math.max(columns[1] - columns[0], rows[1] - rows[0]);
    if (round === ROUNDS || size >= FILLED - 4) return mask;
    const [grown, growX, growY] = fitOf(columns, rows);
    fit = [grown * scale, grown * moveX + growX, grown * moveY + growY];
  }
}

/** Drawings until the size is final. Each can be 100 times as large as the one before. */
const ROUNDS = 4;

/** Places a rectangle in the middle of the grid. */
function fitOf([left, right]: readonly number[], [top, bottom]: readonly number[]): Fit {
  const scale = FILLED / Math.max(right - left, bottom - top);
  return [scale, SIDE / 2 - (scale * (left + right)) / 2, SIDE / 2 - (scale * (top + bottom)) / 2];
}

/** The columns and the rows that a mask covers: the first, and the one after the last. */
function extentOf(mask: Uint8Array): [columns: [number, number], rows: [number, number]] {
  const columns: [number, number] = [SIDE, 0];
  const rows: [number, number] = [SIDE, 0];
  for (let at = 0; at < mask.length; at++) {
    if (mask[at] === 0) continue;
    const [column, row] = [at % SIDE, Math.floor(at / SIDE)];
    columns[0] = Math.min(columns[0], column);
    columns[1] = Math.max(columns[1], column + 1);
    rows[0] = Math.min(rows[0], row);
    rows[1] = row + 1;
  }
  return [columns, rows];
}

type Segment = readonly [x: number, y: number, toX: number, toY: number];

/** Cuts a mesh in the middle of each layer. */
function masksOfMesh({ positions, indices }: PlainMesh): Uint8Array[] {
  const count = indices ? indices.length : positions.length / 3;
  const corner = (index: number): readonly number[] => {
    const vertex = 3 * (indices ? indices[index] : index);
    return [positions[vertex], positions[vertex + 1], positions[vertex + 2]];
  };
  const ends = [0, 1, 2].map((axis) => {
    let [low, high] = [Infinity, -Infinity];
    for (let index = 0; index < count; index++) {
      const place = corner(index)[axis];
      if (!Number.isFinite(place)) throw new ShapeError('The mesh has vertices without finite places.');
      [low, high] = [Math.min(low, place), Math.max(high, place)];
    }
    return [low, high];
  });
  const [scale, moveX, moveY] = fitOf(ends[0], [-ends[1][1], -ends[1][0]]);
  const [back, front] = ends[2];
  return Array.from({ length: Math.min(LAYERS, MAX_LAYERS) }, (_, layer) => {
    const z = back + ((front - back) * (layer + 0.5)) / LAYERS;
    const segments: Segment[] = [];
    for (let index = 0; index + 2 < count; index += 3) {
      const crossings = crossingsAt(z, [corner(index), corner(index + 1), corner(index + 2)]);
      const [a, b] = crossings.map(([x, y]) => [scale * x + moveX, moveY - scale * y]);
      if (b) segments.push([a[0], a[1], b[0], b[1]]);
    }
    return maskOfSegments(segments);
  });
}

/** The places at which the edges of a triangle cross a plane: none or two. */
function crossingsAt(z: number, corners: readonly (readonly number[])[]): number[][] {
  return corners.flatMap((from, index) => {
    const to = corners[(index + 1) % 3];
    if (from[2] < z === to[2] < z) return [];
    const share = (z - from[2]) / (to[2] - from[2]);
    return [[from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])]];
  });
}

/** The pixels that are inside an odd number of the lines that segments form. */
function maskOfSegments(segments: readonly Segment[]): Uint8Array {
  const mask = new Uint8Array(SIDE * SIDE);
  for (let row = 1; row < SIDE - 1; row++) {
    const y = row + 0.5;
    const crossings = segments.flatMap(([ax, ay, bx, by]) =>
      ay <= y === by <= y ? [] : [ax + ((y - ay) / (by - ay)) * (bx - ax)],
    );
    crossings.sort((a, b) => a - b);
    for (let at = 0; at + 1 < crossings.length; at += 2)
      mask.fill(1, row * SIDE + Math.round(crossings[at]), row * SIDE + Math.round(crossings[at + 1]));
  }
  return mask;
}
