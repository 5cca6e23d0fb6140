/**
 * The errors of the library: each says what happened, with which value, what would have been accepted and what to do.
 * They live with the presets because that folder imports nothing else of ours, so everyone may use them.
 */
export class SmokeError extends Error {
  override name = 'SmokeError';
}

/** A parameter that a caller gave is not a number, or lies outside its range. Nothing was changed. */
export class ParameterError extends SmokeError {
  override name = 'ParameterError';
  /** The flat dotted key, such as `emission.rate`. */
  readonly key: string;
  /** The offending value as it was given. */
  readonly value: unknown;
  /** What would have been accepted, in words. */
  readonly accepted: string;

  constructor(key: string, value: unknown, accepted: string) {
    // A text that looks like a number would otherwise be refused without a word on why.
    super(`${key} cannot be ${typeof value === 'string' ? `“${value}”` : String(value)}: it takes ${accepted}.`);
    this.key = key;
    this.value = value;
    this.accepted = accepted;
  }
}

/** A mesh cannot become a puff; the message says what is wrong with it and what would be accepted. */
export class ShapeError extends SmokeError {
  override name = 'ShapeError';
}

/** A file holds no preset and no take; the message says what is wrong with it, and where. */
export class FileError extends SmokeError {
  override name = 'FileError';
}

/** Something that smoke needs could not be fetched or compiled; `cause` holds the reason. */
export class LoadError extends SmokeError {
  override name = 'LoadError';
}

/** This browser lacks something that smoke cannot do without (WebGL2, WASM SIMD). */
export class UnsupportedError extends SmokeError {
  override name = 'UnsupportedError';
}

/** The simulator refused a call or has stopped after a fault; make a new one. */
export class SimulatorError extends SmokeError {
  override name = 'SimulatorError';
}

/** The WebGL context is lost or was disposed. */
export class ContextError extends SmokeError {
  override name = 'ContextError';
}
