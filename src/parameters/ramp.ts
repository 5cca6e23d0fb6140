/**
 * Text format of ramps: stops `0:333344,.5:aab0c0,1:ffffff`, each a position from 0 to 1 and an sRGB colour, with
 * increasing positions.
 */

/** A colour and the position on the ramp where it starts. */
export interface RampStop {
  /** 0..1, written with three decimal places. */
  readonly at: number;
  /** `#rrggbb` in lower case. */
  readonly color: string;
}

export const MIN_COLORS = 2;
/** The limit of the ramp texture. */
export const MAX_COLORS = 16;

const STOP = /^(0|1|0?\.\d+|1\.0+|0\.0*):([0-9a-f]{6})$/i;

/** Parses a ramp. Returns no stops for an empty text, undefined if the text is invalid. */
export function readRamp(text: string): RampStop[] | undefined {
  if (text === '') return [];
  const stops = text.split(',').map(readStop);
  if (stops.length < MIN_COLORS || stops.length > MAX_COLORS) return undefined;
  if (!stops.every((stop) => stop !== undefined)) return undefined;
  return stops.every(({ at }, index) => index === 0 || at > stops[index - 1].at) ? stops : undefined;
}

function readStop(text: string): RampStop | undefined {
  const match = STOP.exec(text.trim());
  return match ? { at: Number(match[1]), color: `#${match[2].toLowerCase()}` } : undefined;
}

/** Formats a ramp with three decimal places and without leading zeros. */
export function writeRamp(stops: readonly RampStop[]): string {
  const short = (at: number) => String(Number(at.toFixed(3))).replace(/^0\./, '.');
  return stops.map(({ at, color }) => `${short(at)}:${color.slice(1)}`).join(',');
}
