/** Traces sketches to vector drawings. The result depends only on the sketch. */
import {
  DRAWING_LIMIT,
  drawingText,
  ringsOf,
  SIDE,
  simplified,
  areaOf,
  type DrawnArea,
  type Line,
  type PuffDrawing,
} from '../../internal.ts';
import { withoutSpecks, type Sketch } from './sketch.ts';

/** Deviation in units with which tracing begins, and its growth while the text is too long, or several times so. */
const FIRST_TOLERANCE = 0.6;
const [SLOW_GROWTH, FAST_GROWTH] = [1.2, 1.8];
/** From this deviation on, specks are removed, too, in a few rounds. */
const ROUGH = 2;
const SPECK_ROUNDS = 4;

export interface Trace {
  /** Empty if nothing is painted. */
  readonly text: string;
  /** Whether details were lost, so that the text fits into a link. */
  readonly isRough: boolean;
}

/** The text of a sketch, as exact as the maximum length allows. */
export function traceSketch({ pixels, colors, folds }: Sketch): Trace {
  let layers = layersOf(pixels);
  if (layers.length === 0) return { text: '', isRough: false };
  let rounds = 0;
  for (let tolerance = FIRST_TOLERANCE; ;) {
    if (tolerance > ROUGH && rounds++ < SPECK_ROUNDS) {
      pixels = withoutSpecks(pixels);
      const smoother = layersOf(pixels);
      if (smoother.length > 0) layers = smoother;
    }
    const drawing: PuffDrawing = {
      areas: areasOf(layers, colors, tolerance),
      folds: folds.filter((fold) => lengthOf(fold) > 3 * tolerance).map((fold) => simplified(fold, tolerance)),
    };
    const text = drawingText(drawing);
    if (text.length <= DRAWING_LIMIT) return { text, isRough: tolerance > ROUGH };
    tolerance *= text.length > 3 * DRAWING_LIMIT ? FAST_GROWTH : SLOW_GROWTH;
  }
}

/** The outlines of a colour, in steps of one unit. */
interface Layer {
  readonly value: number;
  readonly rings: readonly Line[];
}

/** Layers to paint in order, the most frequent colour first. */
function layersOf(pixels: Uint8Array): Layer[] {
  const counts = new Uint32Array(256);
  for (const pixel of pixels) counts[pixel]++;
  const values = [...counts.keys()].filter((value) => value > 0 && counts[value] > 0);
  values.sort((a, b) => counts[b] - counts[a]);
  // Nothing comes before everything else, and no value is painted before it.
  const order = new Uint8Array(256);
  values.forEach((value, rank) => (order[value] = rank + 1));
  return values.map((value) => ({ value, rings: ringsOf(maskOf(pixels, order, order[value])) }));
}

/** Half the width in pixels of the margin that a colour has under its neighbours. */
const MARGIN = 4;

/**
 * The pixels that a layer covers: its own, and below later layers a margin, so that simplified borders leave no gap, and
 * what its own and the margin enclose.
 */
function maskOf(pixels: Uint8Array, order: Uint8Array, rank: number): Uint8Array {
  const wide = dilated(dilated(pixels.map((pixel) => (order[pixel] === rank ? 1 : 0)), 1), SIDE); // prettier-ignore
  // Closed to the flood from outside: what the layer covers. Visited places close, too.
  const isClosed = pixels.map((pixel, at) => (order[pixel] >= rank ? wide[at] : 0));
  const mask = new Uint8Array(pixels.length).fill(1);
  const open = new Uint32Array(pixels.length);
  let count = 0;
  const visit = (at: number): void => {
    if (isClosed[at] !== 0) return;
    isClosed[at] = 1;
    mask[at] = 0;
    open[count++] = at;
  };
  pixels.forEach((pixel, at) => order[pixel] < rank && visit(at));
  while (count > 0) {
    const at = open[--count];
    visit(at - 1);
    visit(at + 1);
    visit(at - SIDE);
    visit(at + SIDE);
  }
  return mask;
}

/** Widens a mask along one axis. */
function dilated(mask: Uint8Array, step: number): Uint8Array {
  const wide = mask.slice();
  for (let at = 0; at < mask.length; at++) {
    // Only the border of a region widens it.
    if (mask[at] === 0 || (mask[at - step] === 1 && mask[at + step] === 1)) continue;
    for (let away = -MARGIN; away <= MARGIN; away++) wide[at + away * step] = 1;
  }
  return wide;
}

function areasOf(layers: readonly Layer[], colors: readonly string[], tolerance: number): DrawnArea[] {
  const largest = Math.max(...layers.flatMap(({ rings }) => rings.map(areaOf)));
  const least = Math.min(2 * tolerance ** 2, largest);
  return layers.flatMap(({ value, rings }) => {
    const lines = rings.filter((ring) => areaOf(ring) >= least).map((ring) => simplified(ring, tolerance));
    // Outlines close themselves.
    const outlines = lines.map((line) => line.slice(0, -1)).filter((line) => line.length > 2);
    return outlines.length > 0 ? [{ color: colors[value - 1], outlines }] : [];
  });
}

function lengthOf(line: Line): number {
  return line.slice(1).reduce((sum, [x, y], at) => sum + Math.hypot(x - line[at][0], y - line[at][1]), 0);
}
