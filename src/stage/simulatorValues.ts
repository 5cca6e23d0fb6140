import type { Values } from '../preset/parameter.ts';
import { table } from '../preset/table.ts';

const simulatorKeys = new Set(table.filter(({ reader }) => reader === 'simulator').map(({ key }) => key));

/** Of the keys in `changed`, those that the simulator reads, with their values as numbers. */
export function simulatorValues(values: Values, changed: Values): Record<string, number> {
  const keys = Object.keys(changed).filter((key) => simulatorKeys.has(key));
  return Object.fromEntries(keys.map((key) => [key, Number(values[key])]));
}
