import { requireOptions } from '../../base/errors.ts';
import type { ShapeSource } from './trace.ts';

/**
 * Traces a text, a path, a picture or a mesh to the outline of a shape, for `shapes.0.outline`. Call it where the shape
 * is made: the outline is part of links, files and takes, so that it is the same in every browser.
 * @returns text of whole numbers, at most 1,024 characters; details are left out where it would be longer
 * @throws ParameterError if an option is invalid
 * @throws ShapeError if there is nothing to fill, or if the SVG, the image or the mesh cannot be read
 */
export async function traceShape(source: ShapeSource): Promise<string> {
  requireOptions('traceShape', source, ['text', 'font', 'path', 'svg', 'image', 'mesh']);
  const { outlineOf } = await import('./trace.ts');
  return outlineOf(source);
}
