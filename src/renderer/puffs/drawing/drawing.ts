/**
 * Drawings of puffs as vector data, and their text in links: filled areas in colours, and lines along which the relief
 * folds.
 *
 * The sheet is SIDE units wide and high: x to the right, y down, in whole units from 0 to SIDE - 1. The particle's centre
 * is the middle of the sheet, and half a side is one particle radius.
 *
 * Text: up to four variations, joined by `;`. A variation joins its areas and then its folds by `,`. An area is a colour
 * of six hexadecimal digits, `*` and its outlines joined by `.`. The folds are one part without a colour. A line is
 * its first point, `(256 x + y)` in three digits to base 64, then for each step to the next point its x and its y plus
 * 32, one digit each. The digits are those of base64url.
 */
import { ShapeError } from '../../../base/errors.ts';
import { DRAWING_LIMIT, isDrawing } from '../../../base/drawingText.ts';

/** Width and height of the sheet. */
export const SIDE = 256;

/** A point on the sheet, in whole units. */
export type Point = readonly [x: number, y: number];
/** Consecutive points, at least two; the outlines of areas close themselves. */
export type Line = readonly Point[];

/** A region in one colour. A place inside an odd number of its outlines is in the region. */
export interface DrawnArea {
  /** `#rrggbb` in lower case. */
  readonly color: string;
  readonly outlines: readonly Line[];
}

/** One variation. Its silhouette is the union of its areas. */
export interface PuffDrawing {
  /** At least one. Each covers those before it. */
  readonly areas: readonly DrawnArea[];
  /** Open lines. */
  readonly folds: readonly Line[];
}

const DIGITS = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_';
/** Largest step along an axis that a digit holds. Longer steps are divided. */
const LONGEST_STEP = 31;
const ZERO_STEP = 32;

/**
 * Writes variations as text, which is empty if there are none.
 * @throws ShapeError if there are more than four, or one is empty or exceeds DRAWING_LIMIT characters
 */
export function writeDrawings(drawings: readonly PuffDrawing[]): string {
  const text = drawings.map(writeDrawing).join(';');
  if (!isDrawing(text)) throw new ShapeError('Draw at most four puffs, each with at least one area.');
  return text;
}

/** @throws ShapeError if the text exceeds DRAWING_LIMIT characters */
export function writeDrawing(drawing: PuffDrawing): string {
  const text = drawingText(drawing);
  if (text.length > DRAWING_LIMIT) {
    throw new ShapeError(`The drawing has ${text.length} characters. The limit is ${DRAWING_LIMIT}. Simplify it.`);
  }
  return text;
}

/** The text of a variation of any length. */
export function drawingText({ areas, folds }: PuffDrawing): string {
  const parts = areas.map(({ color, outlines }) => `${color.slice(1)}*${outlines.map(writeLine).join('.')}`);
  if (folds.length > 0) parts.push(`*${folds.map(writeLine).join('.')}`);
  return parts.join(',');
}

/**
 * Reads the variations of a text.
 * @throws ShapeError if it is not one
 */
export function readDrawings(text: string): PuffDrawing[] {
  if (text === '' || !isDrawing(text)) throw new ShapeError('This is not the text of a drawing.');
  return text.split(';').map(readDrawing);
}

function readDrawing(text: string): PuffDrawing {
  const parts = text.split(',').map((part) => {
    const [color, lines] = part.split('*');
    return { color, outlines: lines.split('.').map(readLine) };
  });
  return {
    areas: parts.flatMap(({ color, outlines }) => (color ? { color: `#${color}`, outlines } : [])),
    folds: parts.flatMap(({ color, outlines }) => (color ? [] : outlines)),
  };
}

/** The text of a line. */
export function writeLine(line: Line): string {
  let [x, y] = line[0];
  const first = SIDE * x + y;
  let text = DIGITS[first >> 12] + DIGITS[(first >> 6) & 63] + DIGITS[first & 63];
  for (const [nextX, nextY] of line.slice(1)) {
    const steps = Math.max(1, Math.ceil(Math.max(Math.abs(nextX - x), Math.abs(nextY - y)) / LONGEST_STEP));
    const [fromX, fromY] = [x, y];
    for (let step = 1; step <= steps; step++) {
      const toX = Math.round(fromX + ((nextX - fromX) * step) / steps);
      const toY = Math.round(fromY + ((nextY - fromY) * step) / steps);
      text += DIGITS[toX - x + ZERO_STEP] + DIGITS[toY - y + ZERO_STEP];
      [x, y] = [toX, toY];
    }
  }
  return text;
}

/** The line of a text. Points beyond the sheet move to its border. */
export function readLine(text: string): Line {
  const digits = Array.from(text, (digit) => DIGITS.indexOf(digit));
  const first = (digits[0] << 12) | (digits[1] << 6) | digits[2];
  let [x, y] = [onSheet(first >> 8), first & 255];
  const line = [[x, y] as const];
  for (let at = 3; at < digits.length; at += 2) {
    x = onSheet(x + digits[at] - ZERO_STEP);
    y = onSheet(y + digits[at + 1] - ZERO_STEP);
    line.push([x, y]);
  }
  return line;
}

function onSheet(place: number): number {
  return Math.min(SIDE - 1, Math.max(0, place));
}
