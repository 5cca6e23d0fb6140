/** Saved states with the colours of their looks, which follow the bytes of the simulator as text. */
import type { AnyValues, Value, Values } from '../parameters/parameter.ts';
import { findParameter } from '../parameters/table.ts';
import { isAccepted } from '../parameters/values.ts';
import { isOfLookStyle, numbersOfStyles, stylesOf } from './lookStyles.ts';

/** Ends a state with looks, after the length of their text. */
const MARK = 'looks';
const DIGITS = 8;

/** What a saved state has besides the bytes of the simulator. */
export interface SavedLooks {
  /** Numbers of styles, which are known from then on. */
  readonly styles: readonly number[];
  /** Values of the style of emitters of the table. */
  readonly values: Values;
}

/** @param values of which those of looks are saved */
export function withSavedLooks(
  state: Uint8Array,
  styles: Iterable<number>,
  values: AnyValues,
): Uint8Array<ArrayBuffer> {
  const looks = Object.entries(values).filter(([key]) => isOfLookStyle(key));
  const text = JSON.stringify({ styles: stylesOf(styles), values: Object.fromEntries(looks) });
  const tail = new TextEncoder().encode(`${text}${String(text.length).padStart(DIGITS)}${MARK}`);
  const all = new Uint8Array(state.length + tail.length);
  all.set(state);
  all.set(tail, state.length);
  return all;
}

/** The bytes of the simulator, and the looks of a state that may have some. Damaged looks are left out. */
export function splitState(bytes: Uint8Array): SavedLooks & { readonly state: Uint8Array } {
  const textOf = (from: number, to: number) => new TextDecoder().decode(bytes.subarray(from, to));
  const end = bytes.length - MARK.length - DIGITS;
  if (end < 0 || textOf(end + DIGITS, bytes.length) !== MARK) return { state: bytes, styles: [], values: {} };
  const start = end - Number(textOf(end, end + DIGITS));
  const state = bytes.subarray(0, Math.max(0, start || 0));
  try {
    const { styles, values } = JSON.parse(textOf(start, end)) as { styles?: unknown; values?: AnyValues };
    const found = Object.entries(values ?? {}).filter(([key, value]) => isOfLookStyle(key) && isSound(key, value));
    return { state, styles: numbersOfStyles(styles), values: Object.fromEntries(found) };
  } catch {
    return { state, styles: [], values: {} };
  }
}

function isSound(key: string, value: Value): boolean {
  return isAccepted(findParameter(key)!, value);
}
