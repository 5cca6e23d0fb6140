import { encodePng } from '../../internal.ts';
import type { Studio } from './studio.ts';

/** Encodes the current frame without loss. */
export function makePng({ canvas, draw }: Studio): Promise<Blob> {
  draw();
  return encodePng(canvas);
}
