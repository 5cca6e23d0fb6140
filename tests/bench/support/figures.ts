/** Figures, and how rounds become one: a median with its range, since single timings on a shared machine are noise. */

import { median } from './statistics.ts';

/** As scripts/bench.mjs prints and writes it. */
export interface Figure {
  name: string;
  value: number;
  unit: string;
  /** Least and greatest of the rounds. */
  range: [number, number];
  rounds: number;
  note: string;
}

/** A figure from its rounds, at least one. */
export function figure(name: string, unit: string, rounds: readonly number[], note: string): Figure {
  const range: [number, number] = [Math.min(...rounds), Math.max(...rounds)];
  return { name, value: median(rounds), unit, range, rounds: rounds.length, note };
}

/** Stops the suite: a ratio of different work is worth nothing. */
export function demand(holds: boolean, what: string): asserts holds {
  if (!holds) throw new Error(`The work is not the same: ${what}`);
}

/** Milliseconds that `work` takes. */
export function time(work: () => void): number {
  const start = performance.now();
  work();
  return performance.now() - start;
}

declare global {
  /** Put into the page by the suite's runner. */
  var sayProgress: ((line: string) => Promise<void>) | undefined;
}

/** Shows what is being measured; also lets the browser see to its own work between two rounds. */
export async function say(line: string): Promise<void> {
  await globalThis.sayProgress?.(line);
}
