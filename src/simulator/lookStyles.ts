/** The colours and the ink of emitters' looks, which the simulator knows by numbers. */
import type { AnyValues, Value } from '../parameters/parameter.ts';
import { findParameter } from '../parameters/table.ts';
import { isAccepted } from '../parameters/values.ts';

/** What an emitter's look changes of the style. */
export interface LookStyle {
  /** Colours from shadow to full light, as `style.ramp`: stops `0:333344,.5:aab0c0,1:ffffff`; empty for those of the smoke. */
  readonly colors: string;
  /** Colours over the age of a puff, as `style.ageRamp`. */
  readonly ageColors: string;
  /** Colours over its temperature, as `style.heatRamp`. */
  readonly heatColors: string;
  /** Factor on the width of lines, 0 to 4. */
  readonly inkWeight: number;
}

/** The style of smoke without a look. */
export const NO_STYLE: LookStyle = { colors: '', ageColors: '', heatColors: '', inkWeight: 1 };

/** Numbers below stand for values of the table: number n for those of emitter n - 1. */
export const FIRST_NUMBER = 16;
/** Number of styles that are kept. The oldest one gives way. */
const MOST = 4096;
/** Characters of the styles of a take or a saved state. The oldest ones are left out. */
const MOST_CHARACTERS = 16_000;

/** Whether a key of the table is that of the colours or the ink of an emitter's look. */
export function isOfLookStyle(key: string): boolean {
  return key.startsWith('emitters.') && findParameter(key)?.reader === 'style';
}

/** The styles of this thread by their numbers. */
const styles = new Map<number, LookStyle>();

/** The number of a style: a hash of its content, so that states with equal looks have equal hashes. */
export function numberOfStyle(style: LookStyle): number {
  const text = JSON.stringify(Object.values(style));
  // FNV-1a.
  let hash = 0x811c9dc5;
  for (let at = 0; at < text.length; at++) hash = Math.imul(hash ^ text.charCodeAt(at), 0x01000193);
  const number = Math.max(hash >>> 0, FIRST_NUMBER);
  styles.delete(number);
  styles.set(number, style);
  if (styles.size > MOST) styles.delete(styles.keys().next().value!);
  return number;
}

/** The style with a number; undefined if it is unknown. */
export function styleOfNumber(number: number): LookStyle | undefined {
  return styles.get(number);
}

/** The styles with these numbers, for a take or a saved state. @param numbers in the order of their first use */
export function stylesOf(numbers: Iterable<number>): LookStyle[] {
  let length = 0;
  const latest = [...numbers].toReversed().flatMap((number) => styles.get(number) ?? []);
  return latest.filter((style) => (length += JSON.stringify(style).length) < MOST_CHARACTERS).toReversed();
}

/** The numbers of styles of untrusted data, which are known from then on. Invalid parts of them follow the smoke. */
export function numbersOfStyles(given: unknown): number[] {
  return Array.isArray(given) ? given.map((each: AnyValues) => numberOfStyle(soundStyle((name) => each?.[name]))) : [];
}

/** A style of values by their names, without those that are invalid. */
export function soundStyle(valueOf: (name: string) => unknown): LookStyle {
  const entries = Object.entries(NO_STYLE).map(([name, initial]): [string, Value] => {
    const value = valueOf(name);
    return [name, isAccepted(findParameter(`emitters.0.look.${name}`)!, value) ? (value as Value) : initial];
  });
  return Object.fromEntries(entries) as unknown as LookStyle;
}
