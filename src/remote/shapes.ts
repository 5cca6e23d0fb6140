/** Checks of what comes from elsewhere: whether a value has the shape that was agreed on. None of them throws. */

export type Check = (value: unknown) => boolean;

const KEY = /^[A-Za-z][A-Za-z0-9]*(\.[A-Za-z0-9]+)*$/;
const LONGEST_KEY = 100;
const LONGEST_TEXT = 8192;
const MOST_VALUES = 4000;

export const nothing: Check = (value) => value === undefined;

export const flag: Check = (value) => typeof value === 'boolean';

/** Finite and not farther from zero than `most`. */
export function number(most: number): Check {
  return (value) => typeof value === 'number' && Math.abs(value) <= most;
}

export function integer(min: number, max: number): Check {
  return (value) => Number.isInteger(value) && (value as number) >= min && (value as number) <= max;
}

export const text: Check = (value) => typeof value === 'string' && value.length <= LONGEST_TEXT;

export function oneOf(...values: readonly unknown[]): Check {
  return (value) => values.includes(value);
}

export function optional(check: Check): Check {
  return (value) => value === undefined || check(value);
}

export function bytes(most: number): Check {
  return (value) => value instanceof Uint8Array && value.byteLength <= most;
}

export const blob: Check = (value) => value instanceof Blob;

/** A flat dotted key as the table of parameters has them. */
export const key: Check = (value) => typeof value === 'string' && value.length <= LONGEST_KEY && KEY.test(value);

export function list(check: Check, most: number): Check {
  return (value) => Array.isArray(value) && value.length <= most && value.every(check);
}

/** A plain object with these fields and no others. */
export function record(fields: Readonly<Record<string, Check>>): Check {
  const names = Object.keys(fields);
  return (value) => {
    if (!isPlain(value)) return false;
    return Object.keys(value).every((name) => Object.hasOwn(fields, name)) && names.every(hasRight(value, fields));
  };
}

/** Flat values of parameters by their keys; whether the table has them is the stage's to say. */
export const values: Check = (value) => {
  if (!isPlain(value)) return false;
  const entries = Object.entries(value);
  return entries.length <= MOST_VALUES && entries.every(([name, each]) => key(name) && (finite(each) || text(each)));
};

/** A plain object of finite numbers and flags. */
export const figures: Check = (value) =>
  isPlain(value) && Object.values(value).every((each) => finite(each) || flag(each));

const finite: Check = (value) => Number.isFinite(value);

function hasRight(value: Readonly<Record<string, unknown>>, fields: Readonly<Record<string, Check>>) {
  return (name: string) => fields[name](Object.hasOwn(value, name) ? value[name] : undefined);
}

export function isPlain(value: unknown): value is Readonly<Record<string, unknown>> {
  if (typeof value !== 'object' || value === null) return false;
  const prototype: unknown = Object.getPrototypeOf(value);
  return prototype === Object.prototype || prototype === null;
}
