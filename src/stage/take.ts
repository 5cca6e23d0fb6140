/** Takes as used by a stage: the simulator's bytes, with the stage's start values as the note. */
import { SimulatorError } from '../base/errors.ts';
import type { Value, Values } from '../parameters/parameter.ts';
import { findParameter } from '../parameters/table.ts';
import { defaults, differing, isAccepted } from '../parameters/values.ts';
import type { TakeInfo } from '../simulator/input.ts';
import { ChangeLog } from './changeLog.ts';

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

/** Maximum length of a note in the simulator. */
const NOTE_LIMIT = 65_536;

/** The note of a take. It omits defaults, to keep links to takes short. */
export function noteOf(values: Values, log = new ChangeLog()): string {
  const own = differing(defaults(), values);
  const note = JSON.stringify({ values: own, changes: log.pack(), isTruncated: log.isTruncated || undefined });
  return note.length <= NOTE_LIMIT ? note : JSON.stringify({ values: own, isTruncated: true });
}

/** What the note of a take has. */
interface Note {
  readonly values: Values;
  readonly log: ChangeLog;
}

/** @throws SimulatorError when the note was not written by a stage */
export function takeOf(bytes: Uint8Array, { note, end, ...info }: TakeInfo): Take {
  const { values, log } = readNote(note);
  return {
    ...info,
    isTruncated: info.isTruncated || log.isTruncated,
    changed: log.keys,
    values,
    steps: end,
    toBytes: () => bytes.slice(),
  };
}

/**
 * Reads an untrusted note: unknown keys are ignored.
 * @throws SimulatorError for invalid values, and when it was not written by a stage
 */
export function readNote(note: string): Note {
  const { values, changes, isTruncated } = parsed(note);
  const found = Object.entries(values).flatMap(([key, value]): [string, Value][] => {
    const parameter = findParameter(key);
    if (!parameter) return [];
    if (!isAccepted(parameter, value)) throw new SimulatorError(`The take has an invalid ${key}.`);
    return [[parameter.key, value as Value]];
  });
  return {
    values: { ...defaults(), ...Object.fromEntries(found) },
    log: new ChangeLog(changes, isTruncated === true),
  };
}

function parsed(note: string): { values: object; changes?: unknown; isTruncated?: unknown } {
  try {
    const { values, ...others } = JSON.parse(note) as { values?: unknown };
    if (typeof values === 'object' && values !== null) return { values, ...others };
  } catch {
    // Reported below, as for well-formed JSON without values.
  }
  throw new SimulatorError('The take was not recorded by a stage.');
}
