/**
 * Saved states with metadata that the simulator does not know. It follows the bytes of the simulator as JSON, then the number of
 * those bytes and a mark. Without metadata, the bytes are those of the simulator.
 */
import type { AnyValues, Value, Values } from '../parameters/parameter.ts';
import { findParameter } from '../parameters/table.ts';
import { isAccepted } from '../parameters/values.ts';
import { isOfLookStyle, stylesOf } from './lookStyles.ts';

/** "more" in ASCII. */
const MARK = 0x6d6f7265;
const TAIL = 8;

/** Metadata of a saved state; untrusted when it is read. */
interface Metadata {
  /** The colours and the ink of looks. */
  readonly styles?: unknown;
  /** Values of the style for emitters of the table. */
  readonly looks?: AnyValues;
  /** Steps of the changes that people hold against the timeline, by key. */
  readonly held?: unknown;
}

/** A saved state with added metadata, which replaces fields of the same names. */
export function withMetadata(bytes: Uint8Array, added: Metadata): Uint8Array<ArrayBuffer> {
  const { state, meta } = splitState(bytes);
  const text = new TextEncoder().encode(JSON.stringify({ ...meta, ...added }));
  const all = new Uint8Array(state.length + text.length + TAIL);
  all.set(state);
  all.set(text, state.length);
  const tail = new DataView(all.buffer, state.length + text.length);
  tail.setUint32(0, state.length);
  tail.setUint32(4, MARK);
  return all;
}

/** The bytes of the simulator, and the metadata. Damaged metadata is left out. */
export function splitState(bytes: Uint8Array): { readonly state: Uint8Array; readonly meta: Metadata } {
  const end = bytes.length - TAIL;
  const tail = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  if (end < 0 || tail.getUint32(end + 4) !== MARK) return { state: bytes, meta: {} };
  const state = bytes.subarray(0, Math.min(end, tail.getUint32(end)));
  try {
    const meta = JSON.parse(new TextDecoder().decode(bytes.subarray(state.length, end))) as Metadata | null;
    return { state, meta: meta ?? {} };
  } catch {
    return { state, meta: {} };
  }
}

/** @param values of which those of looks are saved */
export function withSavedLooks(
  state: Uint8Array,
  styles: Iterable<number>,
  values: AnyValues,
): Uint8Array<ArrayBuffer> {
  const looks = Object.entries(values).filter(([key]) => isOfLookStyle(key));
  return withMetadata(state, { styles: stylesOf(styles), looks: Object.fromEntries(looks) });
}

/** Values of the style for emitters of the table in a saved state. */
export function savedLooks(bytes: Uint8Array): Values {
  const looks = Object.entries(splitState(bytes).meta.looks ?? {});
  return Object.fromEntries(looks.filter(([key, value]) => isOfLookStyle(key) && isSound(key, value)));
}

function isSound(key: string, value: Value): boolean {
  return isAccepted(findParameter(key)!, value);
}
