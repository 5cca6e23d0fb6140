import type { Studio } from './studio.ts';

/** The picture as it stands, without loss. */
export function makePng({ canvas, draw }: Studio): Promise<Blob> {
  draw();
  return canvas.convertToBlob({ type: 'image/png' });
}
