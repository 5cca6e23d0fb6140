/** User input packed for WASM, and the metadata of a take. */
import { ParameterError } from '../base/errors.ts';

/** A gust of air along a ray, for example from the eye through the pointer. */
export interface Blow {
  /** Origin of the ray, metres, each coordinate within 1000. */
  origin: ArrayLike<number>;
  /** Direction of the ray; any length. */
  ray: ArrayLike<number>;
  /** Peak velocity of the air on the ray, m/s, each component within 50. */
  velocity: ArrayLike<number>;
  /** Radius of the gust around the ray, 0.01 to 10 metres. */
  radius: number;
  /** Duration, 1/60 to 10 seconds. */
  seconds: number;
}

/** Metadata of a take. */
export interface TakeInfo {
  readonly seed: number;
  /** Largest capacity that the take sets. A saved state at its start has its own capacity. */
  readonly mostParticles: number;
  /** Whether the take starts from the initial scene, not from a saved state. */
  readonly isFresh: boolean;
  /** Step counts at the start and the end of the take. */
  readonly start: number;
  readonly end: number;
  /** Number of inputs. */
  readonly inputs: number;
  /** Whether inputs were dropped because the take was full. */
  readonly isTruncated: boolean;
  /** Text that the recording application stored with the take. */
  readonly note: string;
}

/** Packs a blow into eleven numbers. */
export function blowNumbers({ origin, ray, velocity, radius, seconds }: Blow): Float64Array {
  const triples = [origin, ray, velocity].flatMap((triple) => [triple[0], triple[1], triple[2]]);
  return Float64Array.from([...triples, radius, seconds]);
}

/**
 * Packs values for the WASM module: keys joined by newlines, and their numbers.
 * @throws ParameterError for a value that is not a number
 */
export function linesAndNumbers(values: Readonly<Record<string, number>>): [string, Float64Array] {
  const keys = Object.keys(values);
  for (const key of keys) {
    if (typeof values[key] !== 'number') throw new ParameterError(key, values[key], 'a number');
  }
  return [keys.join('\n'), Float64Array.from(keys, (key) => values[key])];
}
