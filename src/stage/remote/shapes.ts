/** Validators for untrusted messages: whether a value has the expected shape. They never throw. */
import { TIMELINE_LIMIT, type Values } from '../../parameters/parameter.ts';
import type { GivenValues } from '../../parameters/timeline.ts';
import type { StageStats } from '../contract.ts';

/** A shape of messages. Unless it has `pack` and `unpack`, the messages are the values themselves. */
export interface Shape<Value = unknown> {
  (message: unknown): boolean;
  /** The accepted values, in words that complete the sentence 'it takes ...'. */
  readonly words: string;
  /** The stage's own check, which throws, so that both report the same error. */
  readonly demand?: (value: unknown) => void;
  /** Converts a value that cannot be cloned. */
  pack?(value: Value): unknown;
  unpack?(message: unknown): Value;
  /** The parts of a message to transfer instead of copying. */
  transferred?(message: unknown): Transferable[];
}

type ValueOf<Of> = Of extends Shape<infer Value> ? Value : never;

const KEY = /^[A-Za-z][A-Za-z0-9]*(\.[A-Za-z0-9]+)*$/;
const LONGEST_KEY = 100;
const LONGEST_TEXT = 8192;
const MAX_VALUES = 4000;
const MAX_OPTIONS = 100;

function shape<Value>(words: string, passes: (value: unknown) => boolean): Shape<Value> {
  return Object.assign((value: unknown) => passes(value), { words });
}

export const anything = shape<unknown>('anything', () => true);

export const nothing = shape<undefined>('nothing', (value) => value === undefined);

export const flag = shape<boolean>('true or false', (value) => typeof value === 'boolean');

const anyNumber = shape<number>('a number', (value) => typeof value === 'number');

/** Between `min` and `max`; `min` defaults to -max, so NaN and infinities fail. */
export function number(max: number, min = -max): Shape<number> {
  return shape(`a number from ${min} to ${max}`, (value) => typeof value === 'number' && value >= min && value <= max);
}

export function integer(min: number, max: number): Shape<number> {
  return shape(
    `a whole number from ${min} to ${max}`,
    (value) => Number.isInteger(value) && (value as number) >= min && (value as number) <= max,
  );
}

export const text = shape<string>('a string', (value) => typeof value === 'string' && value.length <= LONGEST_TEXT);

export function oneOf<const Options extends readonly unknown[]>(...options: Options): Shape<Options[number]> {
  return shape(options.join(', '), (value) => options.includes(value));
}

export function optional<Value>(of: Shape<Value>): Shape<Value | undefined> {
  return shape(of.words, (value) => value === undefined || of(value));
}

export function nullable<Value>(of: Shape<Value>): Shape<Value | null> {
  return shape(`${of.words}, or null`, (value) => value === null || of(value));
}

export function byteArray(max: number): Shape<Uint8Array> {
  const isRight = (value: unknown) => value instanceof Uint8Array && value.byteLength <= max;
  return Object.assign(shape<Uint8Array>(`a Uint8Array of at most ${max} bytes`, isRight), {
    // A part of a buffer is copied: the rest of the buffer, such as WASM memory, must stay.
    transferred: ({ buffer, byteLength }: Uint8Array<ArrayBuffer>) =>
      byteLength === buffer.byteLength ? [buffer] : [],
  });
}

export const blob = shape<Blob>('a Blob', (value) => value instanceof Blob);

/** A flat dotted parameter key. */
export const key = shape<string>(
  'a key',
  (value) => typeof value === 'string' && value.length <= LONGEST_KEY && KEY.test(value),
);

export function list<Value>(of: Shape<Value>, max: number): Shape<Value[]> {
  return shape(
    `an array of at most ${max}, each ${of.words}`,
    (value) => Array.isArray(value) && value.length <= max && value.every(of),
  );
}

/** A plain object with these fields and no others. */
export function record<Fields extends Readonly<Record<string, Shape>>>(
  fields: Fields,
): Shape<{ [Name in keyof Fields]: ValueOf<Fields[Name]> }> {
  const names = Object.keys(fields);
  return shape(`an object of ${names.join(', ')}`, (value) => {
    if (!isPlain(value)) return false;
    return Object.keys(value).every((name) => Object.hasOwn(fields, name)) && names.every(hasRight(value, fields));
  });
}

/** Flat parameter values by key. The stage checks whether the keys exist. */
export const valuesByKey = shape<Values>('an object of numbers and strings by parameter key', (value) => {
  if (!isPlain(value)) return false;
  const entries = Object.entries(value);
  return entries.length <= MAX_VALUES && entries.every(([name, each]) => key(name) && isValue(name, each));
});

function isValue(name: string, value: unknown): boolean {
  if (name === 'timeline') return typeof value === 'string' && value.length <= TIMELINE_LIMIT;
  return Number.isFinite(value) || text(value);
}

/** Values in which the timeline can be an object, which the stage checks. */
export const givenValues = shape<GivenValues>(valuesByKey.words, (value) => {
  if (!isPlain(value)) return false;
  const { timeline, ...others } = value;
  return valuesByKey(isPlain(timeline) ? others : value);
});

const components = record({ x: anyNumber, y: anyNumber, z: anyNumber });

/** Options by name. The stage checks their names and ranges. */
export function optionsByName<Options extends object>(): Shape<Options> {
  return shape('an object of options: numbers, strings, true or false, and vectors x, y, z', (value) => {
    if (!isPlain(value)) return false;
    const entries = Object.entries(value);
    return entries.length <= MAX_OPTIONS && entries.every(([name, each]) => key(name) && isOption(each));
  });
}

function isOption(value: unknown): boolean {
  return value === undefined || anyNumber(value) || flag(value) || text(value) || components(value);
}

/** A plain object of finite numbers and booleans. */
export const figures = shape<StageStats>(
  'an object of numbers and booleans',
  (value) => isPlain(value) && Object.values(value).every((each) => Number.isFinite(each) || flag(each)),
);

function hasRight(value: Readonly<Record<string, unknown>>, fields: Readonly<Record<string, Shape>>) {
  return (name: string) => fields[name](Object.hasOwn(value, name) ? value[name] : undefined);
}

export function isPlain(value: unknown): value is Readonly<Record<string, unknown>> {
  if (typeof value !== 'object' || value === null) return false;
  const prototype: unknown = Object.getPrototypeOf(value);
  return prototype === Object.prototype || prototype === null;
}
