import type { Bitmap2D } from 'lean-qr';
import { createSvg } from './dom.ts';

/** Around a code; a reader needs this many empty modules. */
const QUIET = 4;
/** The most that a code holds, bytes; one that full is too fine for many a camera. */
export const MAX_QR_CHARACTERS = 1200;

/** A QR code of a link. What computes it is fetched when the first one is wanted. */
export async function createQr(link: string, name: string): Promise<SVGSVGElement> {
  const { correction, generate } = await import('lean-qr');
  const code = generate(link, { minCorrectionLevel: correction.L });
  const size = code.size + 2 * QUIET;
  const picture = createSvg('svg', { viewBox: `0 0 ${size} ${size}`, class: 'qr', role: 'img', 'aria-label': name });
  picture.append(
    createSvg('rect', { width: size, height: size, fill: '#ffffff' }),
    createSvg('path', { d: modulesOf(code), fill: '#000000', 'shape-rendering': 'crispEdges' }),
  );
  return picture;
}

/** A square for each dark module. */
function modulesOf(code: Bitmap2D): string {
  const squares: string[] = [];
  for (let y = 0; y < code.size; y++) {
    for (let x = 0; x < code.size; x++) {
      if (code.get(x, y)) squares.push(`M${x + QUIET} ${y + QUIET}h1v1h-1z`);
    }
  }
  return squares.join('');
}
