/** Takes as used by a stage: the simulator's bytes, with the stage's start values as the note. */
import { SimulatorError } from '../base/errors.ts';
import type { Value, Values } from '../parameters/parameter.ts';
import { findParameter } from '../parameters/table.ts';
import { defaults, differing, isAccepted } from '../parameters/values.ts';
import type { TakeInfo } from '../simulator/input.ts';
import { numbersOfStyles, type LookStyle } from '../simulator/lookStyles.ts';

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
  /** Whether there were more inputs than a take can record: 20,000. */
  readonly isTruncated: boolean;
  /** Serializes the take for storage or transfer. */
  toBytes(): Uint8Array<ArrayBuffer>;
}

/**
 * The note for these start values. It omits defaults, to keep links to takes short.
 * @param looks the colours and the ink of emitters that are started during the take
 */
export function noteOf(values: Values, looks: readonly LookStyle[] = []): string {
  return JSON.stringify({ values: differing(defaults(), values), ...(looks.length > 0 && { looks }) });
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
  return { ...info, values: valuesOf(note), steps: end, toBytes: () => bytes.slice() };
}

/** Values from an untrusted note: unknown keys are ignored, invalid values throw. */
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
    // Reported below, as for well-formed JSON without values.
  }
  throw new SimulatorError('The take was not recorded by a stage.');
}
