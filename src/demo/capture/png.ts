import { encodePng, type Studio } from '../../internal.ts';

/** Encodes the current frame without loss. */
export function makePng({ canvas, draw }: Studio): Promise<Blob> {
  draw();
  return encodePng(canvas);
}
