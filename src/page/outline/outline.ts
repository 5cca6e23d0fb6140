/** Outlines of shapes as lines, and their text in links, whose grammar is in `src/base/outlineText.ts`. */
import { readLine, writeLine, type Line } from '../../renderer/puffs/drawing/drawing.ts';

/** Layers from back to front, each with its closed lines. A place inside an odd number of them is in the shape. */
export type Outline = readonly (readonly Line[])[];

/** The text of an outline of any length. */
export function writeOutline(layers: Outline): string {
  return layers.map((lines) => lines.map(writeLine).join('.')).join(';');
}

/** The outline of a valid text. */
export function readOutline(text: string): Outline {
  return text.split(';').map((layer) => (layer === '' ? [] : layer.split('.').map(readLine)));
}
