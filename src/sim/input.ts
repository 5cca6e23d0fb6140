/**
 * What people do to a simulation, as it crosses into WASM, and what a take says of itself.
 */
import { ParameterError } from '../preset/errors.ts';

/** A gust of air along a ray, such as that from the eye through the pointer. */
export interface Blow {
  /** Where the ray begins, metres, each within 1000. */
  origin: ArrayLike<number>;
  /** Where it goes; the length does not matter. */
  ray: ArrayLike<number>;
  /** Velocity of the air on the ray at the height of the gust, metres a second, each within 50. */
  velocity: ArrayLike<number>;
  /** How far from the ray the air moves, 0.01 to 10 metres. */
  radius: number;
  /** How long it lasts, 1/60 to 10 seconds. */
  seconds: number;
}

/** What stands in a take besides its inputs. */
export interface TakeInfo {
  readonly seed: number;
  /** The most particles that it ever makes room for; a saved state that it begins with has its own room. */
  readonly mostParticles: number;
  /** Whether it begins with the scene as it is set up, and not with a saved state. */
  readonly isFresh: boolean;
  /** Whether it ends as it did when it was recorded; takes of version 2 may end differently. */
  readonly isExact: boolean;
  /** Steps that had been made at its start and at its end. */
  readonly start: number;
  readonly end: number;
  /** How many inputs it has. */
  readonly inputs: number;
  /** Whether more was done than it has room for. */
  readonly isTruncated: boolean;
  /** What whoever recorded it wrote beside it. */
  readonly note: string;
}

/** The eleven numbers of a blow. */
export function blowNumbers({ origin, ray, velocity, radius, seconds }: Blow): Float64Array {
  const triples = [origin, ray, velocity].flatMap((triple) => [triple[0], triple[1], triple[2]]);
  return Float64Array.from([...triples, radius, seconds]);
}

/** Keys in lines, and their values, as the module takes them. */
export function linesAndNumbers(values: Readonly<Record<string, number>>): [string, Float64Array] {
  const keys = Object.keys(values);
  for (const key of keys) {
    if (typeof values[key] !== 'number') throw new ParameterError(key, values[key], 'a number');
  }
  return [keys.join('\n'), Float64Array.from(keys, (key) => values[key])];
}
