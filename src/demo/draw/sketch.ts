/** A puff while it is drawn: pixels of up to eight colours, and lines along which it folds. Sketches are immutable. */
import { finished, painting, SIDE, type Line, type Point, type PuffDrawing } from '../../internal.ts';

/** Colours of a new sketch. White keeps the colours of the style, because colours multiply them. */
export const COLORS = ['#ffffff', '#b9b3c9', '#5a4a4f', '#e2574c', '#f2b632', '#6fae6a', '#5b8fd6', '#e89ac0'];
/** Radius of the round paper, which leaves room for outlines at whole units. */
export const PAPER = SIDE / 2 - 1;

export interface Sketch {
  /** SIDE rows from the top: 0 for nothing, otherwise one more than the index of a colour. */
  readonly pixels: Uint8Array;
  /** Eight colours `#rrggbb`. */
  readonly colors: readonly string[];
  readonly folds: readonly Line[];
}

/** What strokes draw. */
export interface Brush {
  readonly tool: 'pen' | 'eraser' | 'fill' | 'fold';
  /** Width in units of the sheet. */
  readonly width: number;
  /** Value of the pixels of the pen. */
  readonly ink: number;
  /** Whether each stroke is repeated on the other side of the vertical axis. */
  readonly isMirrored: boolean;
}

export function emptySketch(): Sketch {
  return { pixels: new Uint8Array(SIDE * SIDE), colors: COLORS, folds: [] };
}

/** Whether a place is on the round paper. */
export function isOnPaper(x: number, y: number): boolean {
  return (x - SIDE / 2) ** 2 + (y - SIDE / 2) ** 2 <= PAPER ** 2;
}

/** Part of the paper that is painted. */
export function coverageOf({ pixels }: Sketch): number {
  return pixels.reduce((count, pixel) => count + Math.sign(pixel), 0) / (Math.PI * PAPER ** 2);
}

/** Draws a straight piece of a stroke with a pen or an eraser. */
export function withStroke(sketch: Sketch, brush: Brush, from: Point, to: Point): Sketch {
  const pixels = sketch.pixels.slice();
  let { folds } = sketch;
  for (const [start, end] of sidesOf(brush, [from, to])) {
    paint(pixels, start, end, brush.width / 2, brush.tool === 'eraser' ? 0 : brush.ink);
    if (brush.tool === 'eraser') folds = folds.filter((fold) => !touches(fold, end, brush.width / 2));
  }
  return { ...sketch, pixels, folds };
}

/** Fills the region of one colour, or of none, at a place. */
export function withFill(sketch: Sketch, brush: Brush, at: Point): Sketch {
  const pixels = sketch.pixels.slice();
  for (const [[x, y]] of sidesOf(brush, [at])) flood(pixels, Math.floor(x), Math.floor(y), brush.ink);
  return { ...sketch, pixels };
}

/** Adds a line along which the puff folds. */
export function withFold(sketch: Sketch, brush: Brush, line: Line): Sketch {
  return { ...sketch, folds: [...sketch.folds, ...sidesOf(brush, line)] };
}

function sidesOf({ isMirrored }: Brush, line: Line): Line[] {
  return isMirrored ? [line, line.map(([x, y]) => [SIDE - x, y])] : [line];
}

function paint(pixels: Uint8Array, from: Point, to: Point, radius: number, value: number): void {
  const range = (a: number, b: number): [first: number, end: number] => [
    Math.max(0, Math.floor(Math.min(a, b) - radius)),
    Math.min(SIDE, Math.ceil(Math.max(a, b) + radius)),
  ];
  const [left, right] = range(from[0], to[0]);
  const [top, bottom] = range(from[1], to[1]);
  for (let y = top; y < bottom; y++) {
    for (let x = left; x < right; x++) {
      const center: Point = [x + 0.5, y + 0.5];
      if (isOnPaper(...center) && distanceTo(center, from, to) <= radius) pixels[y * SIDE + x] = value;
    }
  }
}

function distanceTo([x, y]: Point, [fromX, fromY]: Point, [toX, toY]: Point): number {
  const [dx, dy] = [toX - fromX, toY - fromY];
  const along = ((x - fromX) * dx + (y - fromY) * dy) / Math.max(1e-9, dx * dx + dy * dy);
  const share = Math.min(1, Math.max(0, along));
  return Math.hypot(x - fromX - share * dx, y - fromY - share * dy);
}

function touches(fold: Line, at: Point, radius: number): boolean {
  return fold.some((point, index) => distanceTo(at, point, fold[index + 1] ?? point) <= radius);
}

function flood(pixels: Uint8Array, x: number, y: number, value: number): void {
  const replaced = pixels[y * SIDE + x];
  if (replaced === value || !isOnPaper(x + 0.5, y + 0.5)) return;
  const open = [y * SIDE + x];
  for (let at = open.pop(); at !== undefined; at = open.pop()) {
    if (pixels[at] !== replaced || !isOnPaper((at % SIDE) + 0.5, Math.floor(at / SIDE) + 0.5)) continue;
    pixels[at] = value;
    open.push(at - 1, at + 1, at - SIDE, at + SIDE);
  }
}

/** The sketch of a drawing. Colours beyond the eighth become the eighth. */
export function sketchOf({ areas, folds }: PuffDrawing): Sketch {
  const used = [...new Set(areas.map(({ color }) => color))];
  const colors = [...used, ...COLORS.filter((color) => !used.includes(color))].slice(0, COLORS.length);
  const values = areas.map(({ color }) => (colors.includes(color) ? colors.indexOf(color) : COLORS.length - 1) + 1);
  const topmost = finished(painting(areas, (x, y) => [x, y], SIDE));
  return { pixels: Uint8Array.from(topmost, (area) => (area < 0 ? 0 : values[area])), colors, folds };
}

/** Gives each pixel the most frequent value around it, which removes specks and smooths borders. */
export function withoutSpecks(pixels: Uint8Array): Uint8Array {
  const counts = new Uint8Array(COLORS.length + 1);
  const smooth = pixels.slice();
  for (let at = SIDE + 1; at < SIDE * (SIDE - 1) - 1; at++) {
    const own = pixels[at];
    counts.fill(0);
    let most = own;
    for (let y = at - SIDE; y <= at + SIDE; y += SIDE) for (let x = y - 1; x <= y + 1; x++) counts[pixels[x]]++;
    for (let value = 0; value < counts.length; value++) if (counts[value] > counts[most]) most = value;
    smooth[at] = most;
  }
  return smooth;
}
