import type { AnyValues, Value } from '../parameters/parameter.ts';
import { findParameter } from '../parameters/table.ts';
import { isAccepted } from '../parameters/values.ts';
import { CHANGE_SIZE, LOG_LIMIT, type PackedLog } from './plainLog.ts';

/** Values by flat key; undefined for optional parameters that follow the scene again. */
export type Changes = Readonly<Record<string, Value | undefined>>;

interface Logged {
  readonly step: number;
  value: Value | undefined;
  /** Whether it is of a take that is replayed. */
  readonly isReplayed: boolean;
}

/**
 * What people change over time that the simulator does not record: style, light and camera, and which parameters of its own
 * they take from a timeline. By step, the latest of each.
 */
export class ChangeLog {
  /** Whether changes were too many to be recorded. The last recorded one of a key then has its latest value. */
  isTruncated = false;
  private readonly byKey = new Map<string, Logged[]>();
  private size = 0;

  /** @param isReplayed whether the changes are of a take. Then they are untrusted, and invalid ones are left out */
  constructor([keys, changes]: PackedLog = [[], []], isReplayed = false) {
    for (let at = 0; at < changes.length; at += 3) {
      const [step, index, value] = changes.slice(at, at + 3) as [number, number, Value | null];
      if (isValid(step, keys[index], value)) this.add(step, keys[index], value ?? undefined, isReplayed);
    }
  }

  /** Adds a change. It replaces what the key has at that step and later. */
  add(step: number, key: string, value: Value | undefined, isReplayed = false): void {
    const logged = this.byKey.get(key) ?? [];
    while ((logged.at(-1)?.step ?? -1) >= step) this.size -= sizeOf(logged.pop()!);
    const change = { step, value, isReplayed };
    if (this.size + sizeOf(change) <= LOG_LIMIT) {
      this.size += sizeOf(change);
      logged.push(change);
    } else {
      this.isTruncated = true;
      if (logged.length > 0) logged.at(-1)!.value = value;
    }
    this.byKey.set(key, logged);
  }

  /** Removes the changes of a key. @param keepsReplayed whether without those of a take that is replayed */
  forget(key: string, keepsReplayed: boolean): void {
    const logged = this.byKey.get(key) ?? [];
    const kept = logged.filter(({ isReplayed }) => keepsReplayed && isReplayed);
    for (const change of logged) if (!kept.includes(change)) this.size -= sizeOf(change);
    if (kept.length > 0) this.byKey.set(key, kept);
    else this.byKey.delete(key);
  }

  /** The step of the value that a person last gave a key at or before a time; undefined if it follows again. */
  held(key: string, time: number): number | undefined {
    const last = this.last(key, time);
    return last?.value === undefined ? undefined : last.step;
  }

  /** Style, light and camera at a time, in steps: all keys that ever change. @param start values at the start */
  valuesAt(time: number, start: AnyValues): Changes {
    const keys = [...this.byKey.keys()].filter((key) => findParameter(key)!.reader !== 'simulator');
    const changes = keys.map((key) => {
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
    for (const [key, logged] of this.byKey) {
      const latest = logged.at(-1);
      if (latest && latest.step > step && !latest.isReplayed && !comesAgain(key)) this.add(step, key, latest.value);
    }
  }

  /** As a take has it; undefined without changes. @param hasLook whether with those of style, light and camera */
  pack(hasLook = true): PackedLog | undefined {
    const isKept = ([key]: [string, unknown]) => hasLook || findParameter(key)!.reader === 'simulator';
    const kept = [...this.byKey].filter(isKept);
    const changes = kept.flatMap(([, logged], index) => logged.map(({ step, value }) => [step, index, value ?? null]));
    // Takes of one session have the order of its steps.
    const sorted = changes.sort(([a], [b]) => Number(a) - Number(b)).flat();
    return sorted.length > 0 ? [kept.map(([key]) => key), sorted] : undefined;
  }

  private last(key: string, time: number): Logged | undefined {
    return this.byKey.get(key)?.findLast(({ step }) => step <= time);
  }
}

function isValid(step: unknown, key: unknown, value: unknown): boolean {
  const row = typeof key === 'string' ? findParameter(key) : undefined;
  if (!row || row.reader === 'stage' || !Number.isInteger(step) || (step as number) < 0) return false;
  return value === null ? row.isOptional === true : isAccepted(row, value);
}

/** Of a change as JSON. */
function sizeOf({ value }: Logged): number {
  return String(value).length + CHANGE_SIZE;
}
