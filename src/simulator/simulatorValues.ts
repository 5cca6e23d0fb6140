import { isOutline, packedOutline, unpackedOutline } from '../base/outlineText.ts';
import { MAX_STOPS, readCurve, writeCurve, type Stop } from '../parameters/curve.ts';
import { LOOK_STYLE } from '../parameters/lists.ts';
import type {
  AnyValues,
  CurveParameter,
  OutlineParameter,
  Parameter,
  PathParameter,
  Value,
  Values,
} from '../parameters/parameter.ts';
import { MAX_POINTS, readPath, writePath, type PathPoint } from '../parameters/path.ts';
import { findParameter, table } from '../parameters/table.ts';
import { isOfLookStyle, NO_STYLE } from './lookStyles.ts';
import type { Simulator } from './simulator.ts';

/**
 * Selects the values that the simulator reads and converts them to numbers.
 * @param all values of which those are a part: the colours and the ink of a look are one number
 */
export function simulatorValues(values: AnyValues, all: AnyValues = values): Record<string, number> {
  const numbers: Record<string, number> = {};
  for (const [key, value] of Object.entries(values)) {
    const parameter = findParameter(key);
    if (isOfLookStyle(key)) Object.assign(numbers, lookStyleOf(key, all));
    if (parameter?.reader !== 'simulator') continue;
    if (isText(parameter)) Object.assign(numbers, numbersOf(parameter, String(value)));
    else numbers[key] = numberOf(parameter, value);
  }
  return numbers;
}

const EMITTER = /^emitters\.(\d)\./;

/** The styles of emitters of the table are numbered from 1, so that their colours need not be saved with a state. */
function lookStyleOf(key: string, values: AnyValues): Record<string, number> {
  const [prefix, emitter] = EMITTER.exec(key)!;
  const isSet = ([name, initial]: [string, Value]) => (values[`${prefix}look.${name}`] ?? initial) !== initial;
  const hasStyle = Object.entries(NO_STYLE).some(isSet);
  return { [prefix + LOOK_STYLE]: hasStyle ? 1 + Number(emitter) : 0 };
}

/** A parameter that is one text here and several numbers in the simulator. */
type TextParameter = CurveParameter | PathParameter | OutlineParameter;

function isText(parameter: Parameter): parameter is TextParameter {
  return parameter.kind === 'curve' || parameter.kind === 'path' || parameter.kind === 'outline';
}

function numbersOf(parameter: TextParameter, text: string): Record<string, number> {
  if (parameter.kind === 'curve') return stopsOf(parameter, text);
  if (parameter.kind === 'outline')
    return Object.fromEntries(packedOutline(text).map(([end, number]) => [parameter.key + end, number]));
  const points = readPath(text);
  const entries = Array.from({ length: MAX_POINTS }, (_, index) => [
    `${parameter.key}.${index}`,
    packedPoint(points[index]),
  ]);
  return Object.fromEntries(entries);
}

/** Fills all items of the simulator's list, which never shrinks. */
function stopsOf({ key, default: initial }: CurveParameter, curve: string): Record<string, number> {
  const numbers: Record<string, number> = {};
  const stops = readCurve(curve) ?? [];
  for (let index = 0; index < MAX_STOPS; index++) {
    if (initial === '') {
      numbers[`${key}.${index}`] = packedStop(stops[index]);
      continue;
    }
    // Unused items repeat the last stop.
    const { at, value } = stops[Math.min(index, stops.length - 1)];
    numbers[`density.${index}.age`] = at;
    numbers[`density.${index}.value`] = value;
  }
  return numbers;
}

/** Steps of the places and the values of stops, and what a step of a value counts in a packed stop. */
const STEPS = 65_535;
const VALUE_PLACE = 131_072;

/** A stop as one number, 0 for none. */
export function packedStop(stop: Stop | undefined): number {
  return stop ? 1 + Math.round(stop.at * STEPS) + VALUE_PLACE * Math.round(stop.value * STEPS) : 0;
}

function unpackedStop(number: number): Stop {
  return { at: ((number % VALUE_PLACE) - 1) / STEPS, value: Math.floor(number / VALUE_PLACE) / STEPS };
}

/** Values of a coordinate of a packed point, which are millimetres; half of it is 0. */
const RANGE = 200_000;

/** A point as one number, 0 for none. */
function packedPoint(point: PathPoint | undefined): number {
  return point ? point.reduceRight((packed, metres) => packed * RANGE + Math.round(metres * 1000) + RANGE / 2, 0) : 0;
}

function unpackedPoint(packed: number): PathPoint {
  const parts = [0, 0, 0].map(() => {
    const part = packed % RANGE;
    packed = (packed - part) / RANGE;
    return (part - RANGE / 2) / 1000;
  });
  return parts as unknown as PathPoint;
}

/**
 * Returns `values` updated with the simulator's current parameters, which takes and saved states also change. Omits
 * optional parameters that have the scene's value.
 * @param rig values that the scene sets, as numbers
 */
export function valuesIn(simulator: Simulator, values: AnyValues, rig: Readonly<Record<string, number>>): Values {
  const after: Record<string, Value> = { ...values };
  after['simulation.maxParticles'] = simulator.capacity;
  after.seed = simulator.seed;
  const numbers = simulator.parameters();
  // The colours of a look are not known by the simulator, which knows whether there are any.
  for (const key of Object.keys(values).filter(isOfLookStyle))
    if (!numbers.get(EMITTER.exec(key)![0] + LOOK_STYLE)) delete after[key];
  for (const parameter of table.filter(({ reader }) => reader === 'simulator')) {
    const { key } = parameter;
    if (isText(parameter)) {
      const text = textIn(numbers, parameter, String(values[key] ?? parameter.default));
      if (text) after[key] = text;
      else delete after[key];
      continue;
    }
    const number = numbers.get(key) ?? initialIn(numbers, values, parameter);
    if (number === undefined) delete after[key];
    else if (key in values || number !== (rig[key] ?? numberOf(parameter, parameter.default)))
      after[key] = valueOf(parameter, number);
  }
  return after;
}

/** The default of a parameter that is set, if the simulator has its item: it leaves out some numbers with their defaults. */
function initialIn(numbers: ReadonlyMap<string, number>, values: AnyValues, parameter: Parameter): number | undefined {
  const [item] = EMITTER.exec(parameter.key) ?? [];
  return item && parameter.key in values && numbers.has(`${item}share`)
    ? numberOf(parameter, parameter.default)
    : undefined;
}

/** The simulator's curve or path as text. Returns `known` unchanged if it describes the same one. */
function textIn(numbers: ReadonlyMap<string, number>, parameter: TextParameter, known: string): string {
  const wanted = Object.entries(numbersOf(parameter, known));
  if (wanted.every(([key, number]) => (numbers.get(key) ?? 0) === number)) return known;
  if (parameter.kind === 'path') {
    const packed = wanted.map(([key]) => numbers.get(key) ?? 0).filter((number) => number > 0);
    // Only a forged take has one point.
    return packed.length > 1 ? writePath(packed.map(unpackedPoint)) : '';
  }
  if (parameter.kind === 'outline') {
    const outline = unpackedOutline(wanted.map(([key]) => numbers.get(key) ?? 0));
    return isOutline(outline) ? outline : '';
  }
  const stops =
    parameter.default === ''
      ? wanted.map(([key]) => numbers.get(key) ?? 0).flatMap((number) => (number ? [unpackedStop(number)] : []))
      : Array.from({ length: MAX_STOPS }, (_, index) => ({
          at: numbers.get(`density.${index}.age`) ?? 1,
          value: numbers.get(`density.${index}.value`) ?? 0,
        }));
  return writeCurve(stops.filter(({ at }, index) => index === 0 || at > stops[index - 1].at));
}

/** Converts the simulator's number to the value of a parameter. */
function valueOf(parameter: Parameter, number: number): Value {
  return parameter.kind === 'choice' ? parameter.options[number].value : number;
}

/** The numbers that a scene sets as parameter values: optional parameters only, choices by name. */
export function rigValues(rig: Readonly<Record<string, number>>): Values {
  const entries = Object.entries(rig).map(([key, number]) => [key, findParameter(key), number] as const);
  return Object.fromEntries(
    entries.flatMap(([key, parameter, number]) => (parameter?.isOptional ? [[key, valueOf(parameter, number)]] : [])),
  );
}

/** A choice maps to the index of its option. */
function numberOf(parameter: Parameter, value: Value): number {
  if (parameter.kind !== 'choice') return Number(value);
  return parameter.options.findIndex((option) => option.value === value);
}
