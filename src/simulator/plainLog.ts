import type { Value } from '../parameters/parameter.ts';

/** Maximum length of a log of changes as JSON, in characters. */
export const LOG_LIMIT = 40_000;

/** A change by a person of style, light or camera, or of an animated parameter; null if it follows the scene again. */
export type Change = [step: number, key: string, value: Value | null];

/** Changes while there is neither a timeline nor a take that is replayed. */
export class PlainLog {
  isTruncated = false;
  readonly list: Change[] = [];
  private size = 0;

  /** Adds a change. It replaces that of the same key at the same step. */
  add(step: number, key: string, value: Value | null): void {
    const last = this.list.findLast((change) => change[0] < step || change[1] === key);
    if (last?.[0] === step) last[2] = value;
    else if ((this.size += String(value).length + 12) <= LOG_LIMIT) this.list.push([step, key, value]);
    else this.isTruncated = true;
  }

  /** Goes back to a step: what was changed since stays as it is, as if it were changed at that step. */
  rewind(step: number): void {
    for (const change of this.list) change[0] = Math.min(change[0], step);
  }
}
