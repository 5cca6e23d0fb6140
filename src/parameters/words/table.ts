/** The parameter table with what the panel and the documents say of each parameter. */
import type * as bare from '../parameter.ts';
import { table as rows } from '../table.ts';
import { itemWords } from './lists.ts';
import { smokeWords } from './smoke.ts';
import { styleWords } from './style.ts';
import { viewWords } from './view.ts';
import type { AnyWords, Parameter } from './words.ts';

/** Groups of the panel in order. `advanced` groups start collapsed. */
export const groups: readonly { readonly key: string; readonly label: string; readonly advanced: boolean }[] = [
  { key: 'emission', label: 'Smoke', advanced: false },
  { key: 'style', label: 'Ink and colour', advanced: false },
  { key: 'light', label: 'Light', advanced: false },
  { key: 'camera', label: 'Camera', advanced: true },
  { key: 'puff', label: 'Shape of the puffs', advanced: true },
  { key: 'forces', label: 'Forces', advanced: false },
  { key: 'turbulence', label: 'Turbulence', advanced: true },
  { key: 'air', label: 'Air and weight', advanced: true },
  { key: 'simulation', label: 'Simulation', advanced: true },
];

const singleWords: Readonly<Record<string, AnyWords>> = { ...smokeWords, ...styleWords, ...viewWords };

/** All parameters that the panel, links and attributes can set. */
export const table: readonly Parameter[] = rows.map(described);

const byKey: ReadonlyMap<string, Parameter> = new Map(table.map((parameter) => [parameter.key, parameter]));

/** The row with this key, or undefined. Safe for untrusted keys, `__proto__` included. */
export function findParameter(key: string): Parameter | undefined {
  return byKey.get(key);
}

function described(row: bare.Parameter): Parameter {
  const { options, ...says } = itemWords(row) ?? singleWords[row.key];
  const shown = { group: row.key.split('.')[0], ...says };
  if (row.kind !== 'choice') return { ...('min' in row && { slider: 'even' }), ...row, ...shown } as Parameter;
  const labelOf = (value: bare.Value) => options?.[value] ?? sentence(String(value));
  return { ...row, ...shown, options: row.options.map(({ value }) => ({ value, label: labelOf(value) })) };
}

/** Converts `coneNozzle` to 'Cone nozzle'. */
function sentence(name: string): string {
  const lower = name.replace(/[A-Z]/g, (letter) => ` ${letter.toLowerCase()}`);
  return lower[0].toUpperCase() + lower.slice(1);
}
