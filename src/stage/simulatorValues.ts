import type { Parameter, Value, Values } from '../preset/parameter.ts';
import { findParameter } from '../preset/table.ts';

/** Of `values`, those that the simulator reads, as its numbers. */
export function simulatorValues(values: Values): Record<string, number> {
  const numbers: Record<string, number> = {};
  for (const [key, value] of Object.entries(values)) {
    const parameter = findParameter(key);
    if (parameter?.reader === 'simulator') numbers[key] = numberOf(parameter, value);
  }
  return numbers;
}

/** The value of a parameter as people see it, from the number that the simulator has. */
export function valueOf(parameter: Parameter, number: number): Value {
  return parameter.kind === 'choice' ? parameter.options[number].value : number;
}

/** Choices are numbered from 0 on. */
function numberOf(parameter: Parameter, value: Value): number {
  if (parameter.kind !== 'choice') return Number(value);
  return parameter.options.findIndex((option) => option.value === value);
}
