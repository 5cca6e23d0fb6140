/** Validators for untrusted messages: whether a value has the expected shape. They never throw. */

export interface Check {
  (value: unknown): boolean;
  /** The accepted values, in words that complete the sentence 'it takes ...'. */
  readonly words: string;
}

const KEY = /^[A-Za-z][A-Za-z0-9]*(\.[A-Za-z0-9]+)*$/;
const LONGEST_KEY = 100;
const LONGEST_TEXT = 8192;
const MAX_VALUES = 4000;

function shape(words: string, passes: (value: unknown) => boolean): Check {
  return Object.assign((value: unknown) => passes(value), { words });
}

export const anything = shape('anything', () => true);

export const nothing = shape('nothing', (value) => value === undefined);

export const flag = shape('true or false', (value) => typeof value === 'boolean');

/** Between `min` and `max`; `min` defaults to -max, so NaN and infinities fail. */
export function number(max: number, min = -max): Check {
  return shape(`a number from ${min} to ${max}`, (value) => typeof value === 'number' && value >= min && value <= max);
}

export function integer(min: number, max: number): Check {
  return shape(
    `a whole number from ${min} to ${max}`,
    (value) => Number.isInteger(value) && (value as number) >= min && (value as number) <= max,
  );
}

export const text = shape('a string', (value) => typeof value === 'string' && value.length <= LONGEST_TEXT);

export function oneOf(...values: readonly unknown[]): Check {
  return shape(values.join(', '), (value) => values.includes(value));
}

export function optional(check: Check): Check {
  return shape(check.words, (value) => value === undefined || check(value));
}

export function bytes(max: number): Check {
  return shape(
    `a Uint8Array of at most ${max} bytes`,
    (value) => value instanceof Uint8Array && value.byteLength <= max,
  );
}

export const blob = shape('a Blob', (value) => value instanceof Blob);

/** A flat dotted parameter key. */
export const key = shape(
  'a key',
  (value) => typeof value === 'string' && value.length <= LONGEST_KEY && KEY.test(value),
);

export function list(check: Check, max: number): Check {
  return shape(
    `an array of at most ${max}, each ${check.words}`,
    (value) => Array.isArray(value) && value.length <= max && value.every(check),
  );
}

/** A plain object with these fields and no others. */
export function record(fields: Readonly<Record<string, Check>>): Check {
  const names = Object.keys(fields);
  return shape(`an object of ${names.join(', ')}`, (value) => {
    if (!isPlain(value)) return false;
    return Object.keys(value).every((name) => Object.hasOwn(fields, name)) && names.every(hasRight(value, fields));
  });
}

/** Flat parameter values by key. The stage checks whether the keys exist. */
export const values = shape('an object of numbers and strings by parameter key', (value) => {
  if (!isPlain(value)) return false;
  const entries = Object.entries(value);
  return (
    entries.length <= MAX_VALUES && entries.every(([name, each]) => key(name) && (Number.isFinite(each) || text(each)))
  );
});

/** A plain object of finite numbers and booleans. */
export const figures = shape(
  'an object of numbers and booleans',
  (value) => isPlain(value) && Object.values(value).every((each) => Number.isFinite(each) || flag(each)),
);

function hasRight(value: Readonly<Record<string, unknown>>, fields: Readonly<Record<string, Check>>) {
  return (name: string) => fields[name](Object.hasOwn(value, name) ? value[name] : undefined);
}

export function isPlain(value: unknown): value is Readonly<Record<string, unknown>> {
  if (typeof value !== 'object' || value === null) return false;
  const prototype: unknown = Object.getPrototypeOf(value);
  return prototype === Object.prototype || prototype === null;
}
