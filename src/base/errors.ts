/**
 * Errors of the library. Each message has the cause, the value, what is accepted and what to do. They are in the preset
 * folder because it imports no other folder of the project, so all others can import it.
 */
export class SmokeError extends Error {
  override name = 'SmokeError';
}

/** A parameter is unknown, or its value is invalid or out of range. Nothing was changed. */
export class ParameterError extends SmokeError {
  override name = 'ParameterError';
  /** The flat dotted key, such as `emission.rate`. */
  readonly key: string;
  /** The invalid value, unchanged. */
  readonly value: unknown;
  /** Description of the accepted values. */
  readonly accepted: string;

  constructor(key: string, value: unknown, accepted: string) {
    // Quotes show that a value such as '5' is a string and not a number.
    super(`${key} cannot be ${typeof value === 'string' ? `“${value}”` : String(value)}: it takes ${accepted}.`);
    this.key = key;
    this.value = value;
    this.accepted = accepted;
  }
}

/**
 * Validates the options of a call, which may be any value of JavaScript.
 * @param known the names of all options
 * @throws ParameterError unless it is an object with these options only
 */
export function requireOptions(call: string, options: unknown, known: readonly string[]): void {
  const names = known.join(', ');
  if (typeof options !== 'object' || options === null)
    throw new ParameterError(call, options, `an object with the options ${names}`);
  for (const [name, value] of Object.entries(options)) {
    if (!known.includes(name)) throw new ParameterError(`${call}.${name}`, value, `no value: its options are ${names}`);
  }
}

/** A mesh or shape cannot be used as a puff. The message has the fault and what is accepted. */
export class ShapeError extends SmokeError {
  override name = 'ShapeError';
}

/** A file contains no valid preset, take or model. The message has the fault and its position. */
export class FileError extends SmokeError {
  override name = 'FileError';
}

/** A required resource could not be fetched or compiled. `cause` is the original error. */
export class LoadError extends SmokeError {
  override name = 'LoadError';
}

/** The browser lacks a required feature (WebGL2, WASM SIMD). */
export class UnsupportedError extends SmokeError {
  override name = 'UnsupportedError';
}

/** The simulator rejected a call, or has stopped after a fault. After a fault, create a new one. */
export class SimulatorError extends SmokeError {
  override name = 'SimulatorError';
}

/** The WebGL context is lost or has been disposed. */
export class ContextError extends SmokeError {
  override name = 'ContextError';
}
