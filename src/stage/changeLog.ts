import { SimulatorError } from '../base/errors.ts';
import type { AnyValues, Value } from '../parameters/parameter.ts';
import { findParameter } from '../parameters/table.ts';
import { isAccepted } from '../parameters/values.ts';

/** Maximum length of a log as JSON, in characters. */
const LOG_LIMIT = 40_000;

/** Values by flat key; undefined for optional parameters that follow the scene again. */
export type Changes = Readonly<Record<string, Value | undefined>>;

interface Change {
  readonly step: number;
  value: Value | undefined;
  /** Whether it is of a take that is replayed. */
  readonly isReplayed: boolean;
}

/** Changes as JSON: for each key the step of the first, its value, the steps to the next one, its value; null for none. */
export type PackedChanges = Readonly<Record<string, readonly (Value | null)[]>>;

/**
 * What people change over time that the simulator does not record: style, light and camera, and which parameters of its own
 * they take from a timeline. By step, the latest of each.
 */
export class ChangeLog {
  /** Whether changes were too many to be recorded. The last recorded one of a key then has its latest value. */
  isTruncated: boolean;
  private readonly byKey = new Map<string, Change[]>();
  private length = 0;

  /** @throws SimulatorError for packed changes that no log has made */
  constructor(packed: unknown = {}, isTruncated = false) {
    this.isTruncated = isTruncated;
    for (const [key, list] of Object.entries(Object(packed) as PackedChanges)) this.unpack(key, list);
  }

  /** Adds a change. It replaces what the key has at that step and later. */
  add(step: number, key: string, value: Value | undefined, isReplayed = false): void {
    const list = this.byKey.get(key) ?? [];
    while ((list.at(-1)?.step ?? -1) >= step) this.length -= lengthOf(list.pop()!);
    const change = { step, value, isReplayed };
    const length = lengthOf(change) + (list.length > 0 ? 0 : key.length);
    if (this.length + length <= LOG_LIMIT) {
      this.length += length;
      list.push(change);
    } else {
      this.isTruncated = true;
      if (list.length > 0) list.at(-1)!.value = value;
    }
    this.byKey.set(key, list);
  }

  /** Keys of style, light and camera that ever change. */
  get keys(): string[] {
    return [...this.byKey.keys()].filter((key) => findParameter(key)!.reader !== 'simulator');
  }

  /** The step of the value that a person last gave a key at or before a time; undefined if it follows again. */
  held(key: string, time: number): number | undefined {
    const last = this.last(key, time);
    return last?.value === undefined ? undefined : last.step;
  }

  /** The latest change of a key at or before a time, in steps. */
  private last(key: string, time: number): Change | undefined {
    return this.byKey.get(key)?.findLast(({ step }) => step <= time);
  }

  /** Style, light and camera at a time, in steps: all keys that ever change. @param start values at the start */
  valuesAt(time: number, start: AnyValues): Changes {
    const changes = this.keys.map((key) => {
      const change = this.last(key, time);
      return [key, change ? change.value : start[key]] as const;
    });
    return Object.fromEntries(changes);
  }

  /**
   * Goes back to a step. What a person has changed since stays as it is now, as if it were changed at that step; the changes
   * of a replayed take come again.
   * @param comesAgain whether the changes of a key come again in any case
   */
  rewind(step: number, comesAgain: (key: string) => boolean): void {
    for (const [key, list] of this.byKey) {
      const latest = list.at(-1);
      if (latest && latest.step > step && !latest.isReplayed && !comesAgain(key)) this.add(step, key, latest.value);
    }
  }

  /** Undefined without changes. */
  pack(): PackedChanges | undefined {
    const entries = [...this.byKey].map(([key, list]) => {
      const steps = list.map(({ step }, at) => step - (at > 0 ? list[at - 1].step : 0));
      return [key, list.flatMap(({ value }, at) => [steps[at], value ?? null])] as const;
    });
    return entries.length > 0 ? Object.fromEntries(entries) : undefined;
  }

  private unpack(key: string, list: PackedChanges[string]): void {
    const row = findParameter(key);
    if (!row || row.reader === 'stage') return;
    let step = 0;
    for (let at = 0; at < list.length; at += 2) {
      const [passed, given] = [list[at] as number, list[at + 1]];
      const isNone = given === null && row.isOptional;
      if (!Number.isInteger(passed) || passed < 0 || !(isNone || isAccepted(row, given)))
        throw new SimulatorError(`The take has an invalid change of ${key}.`);
      this.add((step += passed), key, (given as Value | null) ?? undefined, true);
    }
  }
}

/** Of a change as JSON: at most ten digits and two commas beside the value. */
function lengthOf({ step, value }: Change): number {
  return String(step).length + JSON.stringify(value ?? null).length + 2;
}
