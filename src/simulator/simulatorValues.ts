import { MAX_STOPS, readCurve, writeCurve } from '../parameters/curve.ts';
import type { AnyValues, Parameter, Value, Values } from '../parameters/parameter.ts';
import { findParameter, table } from '../parameters/table.ts';
import type { Simulator } from './simulator.ts';

/** Selects the values that the simulator reads and converts them to numbers. */
export function simulatorValues(values: AnyValues): Record<string, number> {
  const numbers: Record<string, number> = {};
  for (const [key, value] of Object.entries(values)) {
    const parameter = findParameter(key);
    if (parameter?.reader !== 'simulator') continue;
    if (parameter.kind === 'curve') Object.assign(numbers, stopsOf(String(value)));
    else numbers[key] = numberOf(parameter, value);
  }
  return numbers;
}

/** Fills all items of the simulator's list, which never shrinks: unused items repeat the last stop. */
function stopsOf(curve: string): Record<string, number> {
  const stops = readCurve(curve)!;
  const numbers: Record<string, number> = {};
  for (let index = 0; index < MAX_STOPS; index++) {
    const { at, value } = stops[Math.min(index, stops.length - 1)];
    numbers[`density.${index}.age`] = at;
    numbers[`density.${index}.value`] = value;
  }
  return numbers;
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
  for (const parameter of table.filter(({ reader }) => reader === 'simulator')) {
    const { key } = parameter;
    if (parameter.kind === 'curve') {
      after[key] = curveIn(numbers, String(values[key]));
      continue;
    }
    const number = numbers.get(key);
    if (number === undefined) delete after[key];
    else if (key in values || number !== (rig[key] ?? numberOf(parameter, parameter.default)))
      after[key] = valueOf(parameter, number);
  }
  return after;
}

/** The simulator's curve as text. Returns `known` unchanged if it describes the same curve. */
function curveIn(numbers: ReadonlyMap<string, number>, known: string): string {
  const isKnown = Object.entries(stopsOf(known)).every(([key, number]) => numbers.get(key) === number);
  if (isKnown) return known;
  const stops = Array.from({ length: MAX_STOPS }, (_, index) => ({
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
