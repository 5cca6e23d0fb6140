/** Puffs that are drawn: the shapes of drawings. */
import { finished, type Work } from '../../../base/work.ts';
import { discsInside } from '../billboards/inscribedDiscs.ts';
import type { PuffShape } from '../shapes.ts';
import { readDrawings, writeDrawing, type PuffDrawing } from './drawing.ts';
import { coverageOf, painting, placementOf } from './relief.ts';

/** Cells along each side of the grid on which discs are chosen. */
const CELLS = 128;

/**
 * Makes the shape of a drawing, for `setPuffs` with `puff.form=billboards`. With `puff.form=lobes`, the puff is made of
 * balls inside the silhouette.
 * @param drawing or its text, as in the parameter `puff.drawing`, of which the first variation is used
 * @throws ShapeError if it is invalid or exceeds 1,200 characters
 */
export function drawPuff(drawing: PuffDrawing | string): PuffShape {
  const text = typeof drawing === 'string' ? drawing.split(';')[0] : writeDrawing(drawing);
  return finished(makingShapes(text))[0];
}

/**
 * Makes the shapes of all variations.
 * @throws ShapeError if the text is not one of drawings
 */
export function* makingShapes(text: string): Work<PuffShape[]> {
  const shapes: PuffShape[] = [];
  for (const [index, drawing] of readDrawings(text).entries()) {
    const paint = yield* painting(drawing.areas, placementOf(drawing, CELLS), CELLS);
    const lobes = yield* discsInside(coverageOf(paint), CELLS);
    shapes.push({ name: `drawing ${index + 1}`, lobes, drawing: text.split(';')[index] });
    yield;
  }
  return shapes;
}
