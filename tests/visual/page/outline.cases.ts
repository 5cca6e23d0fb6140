/** What shapes are traced from, in a browser. */
import { isOutline } from '../../../src/base/outlineText.ts';
import { readOutline } from '../../../src/page/outline/outline.ts';
import type { ShapeSource } from '../../../src/page/outline/trace.ts';
import { traceShape } from '../../../src/page/outline/traceShape.ts';

/** How a traced outline covers the sheet, or why there is none. */
export interface Traced {
  readonly error?: string;
  readonly isValid?: boolean;
  readonly lines?: number;
  /** Width and height of the outline in units. */
  readonly size?: readonly number[];
  /** Covered part of its rectangle. */
  readonly covered?: number;
}

/** @param source `canvas` is a ring on a transparent canvas, in place of an image */
export async function traced(source: ShapeSource | 'canvas'): Promise<Traced> {
  try {
    const text = await traceShape(source === 'canvas' ? { image: ring() } : source);
    const lines = readOutline(text).flat();
    const [xs, ys] = [0, 1].map((axis) => lines.flat().map((point) => point[axis]));
    const size = [Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys)];
    const path = new Path2D(lines.map((line) => `M${line.map((point) => point.join()).join('L')}Z`).join(''));
    const context = new OffscreenCanvas(256, 256).getContext('2d')!;
    // oxlint-disable-next-line unicorn/no-array-fill-with-reference-type -- a canvas is no array
    context.fill(path, 'evenodd');
    const { data } = context.getImageData(0, 0, 256, 256);
    const inside = data.filter((value, at) => at % 4 === 3 && value > 127).length;
    return { isValid: isOutline(text), lines: lines.length, size, covered: inside / (size[0] * size[1]) };
  } catch (error) {
    return { error: (error as Error).message };
  }
}

function ring(): OffscreenCanvas {
  const canvas = new OffscreenCanvas(400, 300);
  const context = canvas.getContext('2d')!;
  context.lineWidth = 40;
  context.arc(150, 100, 80, 0, 7);
  context.stroke();
  return canvas;
}

/** Whether the page still runs nothing but our code. */
export function isUntouched(): boolean {
  return !('hacked' in window) && document.querySelector('script[src*="evil"], svg, img, iframe') === null;
}
