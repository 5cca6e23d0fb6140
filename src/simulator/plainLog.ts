import type { Value } from '../parameters/parameter.ts';

/** Maximum length of a log of changes as JSON, in characters, without its keys. */
export const LOG_LIMIT = 40_000;
/** Of a change beside its value: its step, the index of its key and commas. */
export const CHANGE_SIZE = 12;

/**
 * Changes by a person of style, light and camera, and of animated parameters, as takes have them: the keys, and for each
 * change its step, the index of its key and its value; null if it follows the scene again.
 */
export type PackedLog = readonly [keys: readonly string[], changes: readonly (Value | null)[]];

/** Changes while there is neither a timeline nor a take that is replayed. */
export class PlainLog {
  isTruncated = false;
  private readonly keys: string[] = [];
  private readonly changes: (Value | null)[] = [];
  private size = 0;

  get packed(): PackedLog | undefined {
    return this.keys.length > 0 ? [this.keys, this.changes] : undefined;
  }

  /** Adds a change. It replaces that of the same key at the same step. */
  add(step: number, key: string, value: Value | null): void {
    const { keys, changes } = this;
    if (!keys.includes(key)) keys.push(key);
    const index = keys.indexOf(key);
    let at = changes.length - 3;
    while (changes[at] === step && changes[at + 1] !== index) at -= 3;
    if (changes[at] === step) changes[at + 2] = value;
    else if ((this.size += String(value).length + CHANGE_SIZE) <= LOG_LIMIT) changes.push(step, index, value);
    else this.isTruncated = true;
  }

  /** Goes back to a step: what was changed since stays as it is, as if it were changed at that step. */
  rewind(step: number): void {
    const { changes } = this;
    for (let at = 0; at < changes.length; at += 3) changes[at] = Math.min(changes[at] as number, step);
  }
}
