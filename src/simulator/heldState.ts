/**
 * Saved states of smoke with a timeline: what people hold of it follows the bytes of the simulator, as JSON, its length in
 * bytes and a mark. Without any, the bytes are those of the simulator.
 */
import { findParameter } from '../parameters/table.ts';

/** The step of the change by key. */
export type Held = Readonly<Record<string, number>>;

const MARK = 0x68656c64;
const TAIL = 8;

export function withHeld(state: Uint8Array, held: Held = {}): Uint8Array {
  if (Object.keys(held).length === 0) return state;
  const text = new TextEncoder().encode(JSON.stringify(held));
  const bytes = new Uint8Array(state.length + text.length + TAIL);
  bytes.set(state);
  bytes.set(text, state.length);
  const tail = new DataView(bytes.buffer, state.length + text.length);
  tail.setUint32(0, text.length);
  tail.setUint32(4, MARK);
  return bytes;
}

/** Never throws: of damaged bytes, `state` is what the simulator rejects. */
export function withoutHeld(bytes: Uint8Array): { state: Uint8Array; held: Held } {
  const plain = { state: bytes, held: {} };
  const end = bytes.length - TAIL;
  if (end < 0) return plain;
  const tail = new DataView(bytes.buffer, bytes.byteOffset + end);
  const start = end - tail.getUint32(0);
  if (start < 0 || tail.getUint32(4) !== MARK) return plain;
  try {
    const held = Object.entries(JSON.parse(new TextDecoder().decode(bytes.subarray(start, end))) as object);
    const isRight = ([key, step]: [string, unknown]) => findParameter(key) && Number.isInteger(step);
    return { state: bytes.subarray(0, start), held: Object.fromEntries(held.filter(isRight)) as Held };
  } catch {
    return plain;
  }
}
