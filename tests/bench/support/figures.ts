/**
 * Figures, and their aggregation: median and range of the rounds, because single timings on a shared machine are noise.
 */

import { median } from './statistics.ts';

/** In the output format of scripts/bench.mjs. */
export interface Figure {
  name: string;
  value: number;
  unit: string;
  /** Minimum and maximum of the rounds. */
  range: [number, number];
  rounds: number;
  note: string;
}

/** A figure from its rounds, at least one. */
export function figure(name: string, unit: string, rounds: readonly number[], note: string): Figure {
  const range: [number, number] = [Math.min(...rounds), Math.max(...rounds)];
  return { name, value: median(rounds), unit, range, rounds: rounds.length, note };
}

/** Stops the suite: a ratio of different work is meaningless. */
export function demand(holds: boolean, what: string): asserts holds {
  if (!holds) throw new Error(`The work is not the same: ${what}`);
}

/** Milliseconds that `work` takes. */
export function time(work: () => void): number {
  const start = performance.now();
  work();
  return performance.now() - start;
}

/** Milliseconds until the draw calls of `draw` are complete, starting with an idle GPU. Only reading a pixel waits for them. */
export function timeDrawing(gl: WebGL2RenderingContext, draw: () => void): number {
  const pixel = new Uint8Array(4);
  const wait = () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
  wait();
  return time(() => {
    draw();
    wait();
  });
}

declare global {
  /** Exposed to the page by the suite's runner. */
  var sayProgress: ((line: string) => Promise<void>) | undefined;
}

/** Shows the current measurement. Also yields to the browser between two rounds. */
export async function say(line: string): Promise<void> {
  await globalThis.sayProgress?.(line);
}
