/** Takes as a stage gives and takes them: the simulator's bytes, with the stage's values at the start as their note. */
import { SimulatorError } from '../preset/errors.ts';
import type { Value, Values } from '../preset/parameter.ts';
import { findParameter } from '../preset/table.ts';
import { defaults, isAccepted } from '../preset/values.ts';
import type { TakeInfo } from '../sim/input.ts';

/** What a person did, by step, and all that is needed to do it again: the same hash at every step. */
export interface Take {
  /** The stage's values at the start, style and light included. */
  readonly values: Values;
  readonly seed: number;
  /** How many inputs there are. */
  readonly inputs: number;
  /** Steps that had been made at the start and at the end; the start is 0 unless a saved state was restored. */
  readonly start: number;
  readonly steps: number;
  /** The most particles that it makes room for, where it begins with no saved state. */
  readonly mostParticles: number;
  /** Whether it begins with the scene as it is set up, and not with a saved state. */
  readonly isFresh: boolean;
  /** Whether it ends as it did when it was recorded; false for takes of older versions, which may end differently. */
  readonly isExact: boolean;
  /** Whether more was done than a take has room for, 20,000 inputs. */
  readonly isTruncated: boolean;
  /** All of it, for keeping and sending. */
  toBytes(): Uint8Array<ArrayBuffer>;
}

/** The note of a take that begins with these values; takes travel in links, so it leaves out what is as ever. */
export function noteOf(values: Values): string {
  const usual = defaults();
  return JSON.stringify({
    values: Object.fromEntries(Object.entries(values).filter(([key, value]) => usual[key] !== value)),
  });
}

/** @throws SimulatorError when the note is not one that a stage wrote */
export function takeOf(bytes: Uint8Array, { note, end, ...info }: TakeInfo): Take {
  return { ...info, values: valuesOf(note), steps: end, toBytes: () => bytes.slice() };
}

/** Untrusted values: keys that the table does not have are left out, values that it does not take refused. */
function valuesOf(note: string): Values {
  const found = Object.entries(readNote(note)).flatMap(([key, value]): [string, Value][] => {
    const parameter = findParameter(key);
    if (!parameter) return [];
    if (!isAccepted(parameter, value)) throw new SimulatorError(`The take has an invalid ${key}.`);
    return [[parameter.key, value as Value]];
  });
  return { ...defaults(), ...Object.fromEntries(found) };
}

function readNote(note: string): object {
  try {
    const { values } = JSON.parse(note) as { values?: unknown };
    if (typeof values === 'object' && values !== null) return values;
  } catch {
    // Reported below, as for a note that is well-formed and says nothing.
  }
  throw new SimulatorError('The take was not recorded by a stage.');
}
