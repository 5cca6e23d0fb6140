/** Values of the parameter table: defaults, validation, parsing and formatting. */
import { readCurve } from './curve.ts';
import { isDrawing } from '../base/drawingText.ts';
import { isOutline } from '../base/outlineText.ts';
import { ParameterError } from '../base/errors.ts';
import {
  type Preset,
  accepted,
  TIMELINE_LIMIT,
  type NumberParameter,
  type Parameter,
  type AnyValues,
  type Value,
  type Values,
} from './parameter.ts';
import { notice, type Notice } from './notice.ts';
import { PATH } from './path.ts';
import { readRamp } from './ramp.ts';
import { findParameter, table } from './table.ts';

const DECIMAL = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;
const COLOR = /^#[0-9a-f]{6}$/i;

/** Defaults of all parameters that are not optional. */
export function defaults(): Values {
  const needed = table.filter(({ isOptional }) => !isOptional);
  return Object.fromEntries(needed.map((parameter) => [parameter.key, parameter.default]));
}

/** Defaults of all parameters that are not optional, overridden by the preset's values. */
export function presetValues(preset: Pick<Preset, 'values'>): Values {
  return { ...defaults(), ...preset.values };
}

/** The values of `after` that `before` has not. */
export function differing(before: AnyValues, after: AnyValues): Values {
  return Object.fromEntries(Object.entries(after).filter(([key, value]) => before[key] !== value));
}

/**
 * Validates values without changing or rounding them.
 * @throws ParameterError for the first unknown key or invalid value
 */
export function validate(values: AnyValues): void {
  if (typeof values !== 'object' || values === null)
    throw new ParameterError('values', values, "an object such as { 'emission.rate': 60 }");
  for (const [key, value] of Object.entries(values)) {
    const parameter = findParameter(key);
    if (!parameter || !isAccepted(parameter, value)) throw errorOf(key, value, parameter);
  }
}

/** @throws ParameterError if the key is unknown or its parameter is not optional */
export function requireOptional(key: string): void {
  const parameter = findParameter(key);
  if (!parameter?.isOptional) throw errorOf(key, undefined, parameter);
}

/**
 * Validates numbers that are not in the table, because NaN would persist in the simulation.
 * @param numbers by their names in the error
 * @param min 0 if they must not be negative
 * @throws ParameterError for the first that is not finite or is below `min`
 */
export function requireFinite(numbers: Readonly<Record<string, unknown>>, min?: 0): void {
  for (const [key, value] of Object.entries(numbers)) {
    if (!Number.isFinite(value) || (value as number) < min!) {
      throw new ParameterError(key, value, min === 0 ? 'a number from 0' : 'a finite number');
    }
  }
}

/** @throws ParameterError if the value is not an unsigned 32-bit integer */
export function requireWhole(key: string, value: unknown): void {
  if (!Number.isInteger(value) || (value as number) < 0 || (value as number) > 0xffffffff) {
    throw new ParameterError(key, value, 'a whole number from 0 to 4294967295');
  }
}

/** Whether a value is valid for a parameter without conversion. */
export function isAccepted(parameter: Parameter, value: unknown): boolean {
  switch (parameter.kind) {
    case 'toggle':
      return value === 0 || value === 1;
    case 'choice':
      return parameter.options.some((option) => option.value === value);
    case 'color':
      return typeof value === 'string' && COLOR.test(value);
    case 'curve':
      return typeof value === 'string' && (value === parameter.default || readCurve(value) !== undefined);
    case 'ramp':
      return typeof value === 'string' && readRamp(value) !== undefined;
    case 'path':
      return typeof value === 'string' && PATH.test(value);
    case 'drawing':
      return typeof value === 'string' && isDrawing(value);
    case 'outline':
      return typeof value === 'string' && isOutline(value);
    case 'timeline':
      // What it cannot read, `readTimeline` leaves out.
      return typeof value === 'string' && value.length <= TIMELINE_LIMIT;
    case 'integer':
      return Number.isInteger(value) && isInRange(parameter, value as number);
    case 'number':
      return typeof value === 'number' && isInRange(parameter, value);
  }
}

/** Formats a value for a link: numbers in the shortest lossless form, colours without `#`. */
export function writeText(parameter: Parameter, value: Value): string {
  return parameter.kind === 'color' ? String(value).slice(1).toLowerCase() : String(value);
}

/**
 * Parses a value of a link or a file. Out-of-range values are clamped and invalid values replaced by the fallback; both
 * produce a notice.
 * @param source links are untrusted and have the stricter limit `linkMax`
 */
export function readText(
  parameter: Parameter,
  text: string,
  fallback: Value = parameter.default,
  source: 'link' | 'file' = 'link',
): { value: Value; notice?: Notice } {
  if (parameter.kind === 'number' || parameter.kind === 'integer') {
    return readNumber(source === 'file' ? { ...parameter, linkMax: undefined } : parameter, text, fallback);
  }
  const value = parse(parameter, text);
  return value === undefined ? malformed(parameter, text, fallback) : { value };
}

function parse(parameter: Parameter, text: string): Value | undefined {
  if (parameter.kind === 'choice') return parameter.options.find(({ value }) => String(value) === text)?.value;
  if (parameter.kind === 'toggle') return text === '0' ? 0 : text === '1' ? 1 : undefined;
  if (parameter.kind === 'ramp') return readRamp(text) && text;
  if (parameter.kind !== 'color') return isAccepted(parameter, text) ? text : undefined;
  const color = `#${text.replace(/^#/, '').toLowerCase()}`;
  return COLOR.test(color) ? color : undefined;
}

function readNumber(parameter: NumberParameter, text: string, fallback: Value): { value: Value; notice?: Notice } {
  if (!DECIMAL.test(text.trim())) return malformed(parameter, text, fallback);
  const given = Number(text);
  const rounded = parameter.kind === 'integer' ? Math.round(given) : given;
  // Adding 0 turns -0 into 0, because a link cannot represent -0.
  const value = Math.min(Math.max(rounded, parameter.min), parameter.linkMax ?? parameter.max) + 0;
  if (value === given) return { value };
  const sentence = (quoted: string) => `${parameter.key} cannot be ${quoted} here; ${value} is used.`;
  return { value, notice: notice('outOfRange', parameter.key, text, sentence) };
}

function malformed(parameter: Parameter, text: string, fallback: Value): { value: Value; notice: Notice } {
  const sentence = (quoted: string) =>
    `${parameter.key} cannot be ${quoted}: it takes ${accepted(parameter)}. ${fallback === '' ? 'None' : fallback} is used.`;
  return { value: fallback, notice: notice('malformed', parameter.key, text, sentence) };
}

function errorOf(key: string, value: unknown, parameter: Parameter | undefined): ParameterError {
  return new ParameterError(key, value, parameter ? accepted(parameter) : 'no value (no such parameter)');
}

function isInRange({ min, max }: NumberParameter, value: number): boolean {
  return value >= min && value <= max;
}
