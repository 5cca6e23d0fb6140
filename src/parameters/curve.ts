/** Text format of curves: stops `0:1,.5:.8,1:0`, each a position and a value from 0 to 1, with increasing positions. */

/** A position on a curve and the value there, both 0..1. */
export interface Stop {
  readonly at: number;
  readonly value: number;
}

export const MIN_STOPS = 2;
/** The limit of the simulator. */
export const MAX_STOPS = 8;

const NUMBER = /^(0|1|0?\.\d+|1\.0+|0\.0*)$/;

/** Parses a curve. Returns undefined if the text is invalid. */
export function readCurve(text: string): Stop[] | undefined {
  const stops = text.split(',').map(readStop);
  if (stops.length < MIN_STOPS || stops.length > MAX_STOPS) return undefined;
  if (!stops.every((stop) => stop !== undefined)) return undefined;
  const isRising = stops.every(({ at }, index) => index === 0 || at > stops[index - 1].at);
  return isRising ? stops : undefined;
}

function readStop(text: string): Stop | undefined {
  const parts = text.trim().split(':');
  if (parts.length !== 2 || !parts.every((part) => NUMBER.test(part))) return undefined;
  return { at: Number(parts[0]), value: Number(parts[1]) };
}

/** The value of a curve at a position. It is constant before the first stop and after the last. */
export function valueAt(stops: readonly Stop[], at: number): number {
  const next = stops.findIndex((stop) => stop.at > at);
  if (next < 1) return stops.at(next)!.value;
  const [from, to] = [stops[next - 1], stops[next]];
  return from.value + ((at - from.at) / (to.at - from.at)) * (to.value - from.value);
}

/** Formats a curve with three decimal places and without leading zeros. */
export function writeCurve(stops: readonly Stop[]): string {
  const short = (number: number) => String(Number(number.toFixed(3))).replace(/^0\./, '.');
  return stops.map(({ at, value }) => `${short(at)}:${short(value)}`).join(',');
}
