/** Takes as used by a stage: the simulator's bytes, with the stage's start values as the note. */
import { SimulatorError } from '../base/errors.ts';
import type { Value, Values } from '../parameters/parameter.ts';
import { findParameter } from '../parameters/table.ts';
import { defaults, differing, isAccepted } from '../parameters/values.ts';
import type { TakeInfo } from '../simulator/input.ts';
import { numbersOfStyles, type LookStyle } from '../simulator/lookStyles.ts';
import type { PackedLog } from '../simulator/plainLog.ts';

/** A recording of all inputs by step, with everything needed to replay them to the same hash at every step. */
export interface Take {
  /** The stage's values at the start, including style and light. */
  readonly values: Values;
  readonly seed: number;
  /** Number of inputs. */
  readonly inputs: number;
  /** Step count at the start and at the end; the start is 0 unless a saved state was restored. */
  readonly start: number;
  readonly steps: number;
  /** The maximum capacity of the take, if it does not start with a saved state. */
  readonly mostParticles: number;
  /** Whether it starts with the scene's initial state rather than a saved state. */
  readonly isFresh: boolean;
  /**
   * Whether there was more than a take can record: 20,000 inputs, and 40,000 characters for the changes of style, light and
   * camera.
   */
  readonly isTruncated: boolean;
  /** The keys of style, light and camera that it changes by step. */
  readonly changed: readonly string[];
  /** Serializes the take for storage or transfer. */
  toBytes(): Uint8Array<ArrayBuffer>;
}

export interface TakeOptions {
  /** Whether it has the changes of style, light and camera by step, which make it longer. Default: true. */
  look?: boolean;
}

/** What the note of a take has. */
export interface Note {
  readonly values: Values;
  /** Changes over time that the simulator does not record. */
  readonly changes?: PackedLog;
  readonly isTruncated?: boolean;
  /** The colours and the ink of emitters that are started during the take. */
  readonly looks?: readonly LookStyle[];
}

/** The note of a take. It omits defaults, to keep links to takes short. */
export function noteOf({ values, changes, isTruncated, looks = [] }: Note): string {
  return JSON.stringify({
    values: differing(defaults(), values),
    changes,
    ...(isTruncated && { isTruncated }),
    ...(looks.length > 0 && { looks }),
  });
}

/** The numbers of the looks of an untrusted note, which are known from then on. */
export function stylesIn(note: string): number[] {
  try {
    return numbersOfStyles((JSON.parse(note) as { looks?: unknown } | null)?.looks);
  } catch {
    return [];
  }
}

/** @throws SimulatorError when the note was not written by a stage */
export function takeOf(bytes: Uint8Array, { note, end, ...info }: TakeInfo): Take {
  const { values, changes, isTruncated = false } = readNote(note);
  return {
    ...info,
    isTruncated: info.isTruncated || isTruncated,
    changed: changes?.[0].filter(isLook) ?? [],
    values,
    steps: end,
    toBytes: () => bytes.slice(),
  };
}

/** Whether a key is one of style, light or camera. */
export function isLook(key: string): boolean {
  const reader = findParameter(key)?.reader;
  return reader !== undefined && reader !== 'simulator' && reader !== 'stage';
}

/**
 * Reads an untrusted note: unknown keys are ignored. What it changes over time is not checked.
 * @throws SimulatorError for invalid values, and when it was not written by a stage
 */
export function readNote(note: string): Note {
  const { values, changes, isTruncated } = parsed(note);
  const found = Object.entries(values).flatMap(([key, value]): [string, Value][] => {
    const parameter = findParameter(key);
    if (!parameter) return [];
    if (!isAccepted(parameter, value)) throw new SimulatorError(`The take has an invalid ${key}.`);
    return [[parameter.key, value]];
  });
  const hasChanges = Array.isArray(changes?.[0]) && Array.isArray(changes[1]);
  return {
    values: { ...defaults(), ...Object.fromEntries(found) },
    changes: hasChanges ? changes : undefined,
    isTruncated: isTruncated === true,
  };
}

function parsed(note: string): Note {
  try {
    const read = JSON.parse(note) as Note;
    if (typeof read.values === 'object' && read.values !== null) return read;
  } catch {
    // Reported below, as for well-formed JSON without values.
  }
  throw new SimulatorError('The take was not recorded by a stage.');
}
