/**
 * Saved states of smoke with a timeline. What people hold of it follows the bytes of the simulator as JSON, then the number of
 * those bytes and a mark, which `Simulator.restore` knows. Without any, the bytes are those of the simulator.
 */
import { findParameter } from '../parameters/table.ts';
import { HELD_MARK, HELD_TAIL } from './simulator.ts';

/** The step of the change by key. */
export type Held = Readonly<Record<string, number>>;

export function withHeld(state: Uint8Array, held: Held = {}): Uint8Array {
  if (Object.keys(held).length === 0) return state;
  const text = new TextEncoder().encode(JSON.stringify(held));
  const bytes = new Uint8Array(state.length + text.length + HELD_TAIL);
  bytes.set(state);
  bytes.set(text, state.length);
  const tail = new DataView(bytes.buffer, state.length + text.length);
  tail.setUint32(0, state.length);
  tail.setUint32(4, HELD_MARK);
  return bytes;
}

/** What people hold in bytes that the simulator has restored. */
export function heldIn(bytes: Uint8Array): Held {
  const end = bytes.length - HELD_TAIL;
  const tail = new DataView(bytes.buffer, bytes.byteOffset + end);
  if (tail.getUint32(4) !== HELD_MARK) return {};
  try {
    const held = Object.entries(JSON.parse(new TextDecoder().decode(bytes.subarray(tail.getUint32(0), end))) as object);
    const isRight = ([key, step]: [string, unknown]) => findParameter(key) && Number.isInteger(step);
    return Object.fromEntries(held.filter(isRight)) as Held;
  } catch {
    // Damaged bytes after a state that is not.
    return {};
  }
}
