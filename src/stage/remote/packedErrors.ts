/** Serializes errors between threads and pages by name and message, and restores their class. */
import {
  ContextError,
  FileError,
  LoadError,
  ParameterError,
  ShapeError,
  SimulatorError,
  UnsupportedError,
} from '../../base/errors.ts';
import { anything, isPlain, optional, record, text } from './shapes.ts';

export interface PackedError {
  readonly name: string;
  readonly message: string;
  readonly key?: string;
  readonly value?: unknown;
  readonly accepted?: string;
}

const LONGEST_MESSAGE = 2000;
const named = { ContextError, FileError, LoadError, ShapeError, SimulatorError, UnsupportedError };

const isPacked = record({ name: text, message: text, key: optional(text), value: anything, accepted: optional(text) });

export function packError(error: unknown): PackedError {
  if (error instanceof ParameterError) {
    const { name, message, key, accepted } = error;
    return { name, message, key, value: simple(error.value), accepted };
  }
  if (!(error instanceof Error)) return { name: 'Error', message: cut(String(error)) };
  return { name: error.name, message: cut(error.message) };
}

/** @returns undefined if this is not a packed error */
export function unpackError(packed: unknown): Error | undefined {
  if (!isPlain(packed) || !isPacked(packed)) return undefined;
  const { name, message, key, value, accepted } = packed as unknown as PackedError;
  if (name === 'ParameterError') return new ParameterError(key ?? '', value, accepted ?? '');
  if (Object.hasOwn(named, name)) return new named[name as keyof typeof named](message);
  return Object.assign(new Error(message), { name });
}

/** A value that structured cloning always accepts. */
function simple(value: unknown): unknown {
  return ['number', 'boolean', 'undefined'].includes(typeof value) ? value : cut(String(value));
}

function cut(message: string): string {
  return message.slice(0, LONGEST_MESSAGE);
}
