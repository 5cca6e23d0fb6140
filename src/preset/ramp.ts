/** Ramps as text: stops `0:333344,.5:aab0c0,1:ffffff`, each a place from 0 to 1 and an sRGB colour, the places rising. */

/** A colour that holds from a place on. */
export interface RampStop {
  /** 0..1, whole thousandths once written. */
  readonly at: number;
  /** `#rrggbb` in lower case. */
  readonly color: string;
}

export const MIN_COLORS = 2;
/** As many as a person can tell apart and the ramp texture has room for. */
export const MAX_COLORS = 16;

const STOP = /^(0|1|0?\.\d+|1\.0+|0\.0*):([0-9a-f]{6})$/i;

/** The stops of a ramp, none for an empty text; undefined where the text is no ramp. */
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

/** The text of a ramp: three digits behind the point, without the zero before it. */
export function writeRamp(stops: readonly RampStop[]): string {
  const short = (at: number) => String(Number(at.toFixed(3))).replace(/^0\./, '.');
  return stops.map(({ at, color }) => `${short(at)}:${color.slice(1)}`).join(',');
}
