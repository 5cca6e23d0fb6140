/**
 * The parameter table. The order of the rows is the order of keys in a link and of controls in the panel. New rows can
 * go anywhere, but a key is never renamed, because existing links would lose it.
 *
 * The defaults are those of the lamp scene (see presets.ts). Multipliers apply to the scene's value: 1 has no effect.
 */
import { itemLabel, LIST_LIMIT, listNames, listParameters } from './lists.ts';
import type { Parameter } from './parameter.ts';
import { airRows } from './rows/air.ts';
import { cameraRows } from './rows/camera.ts';
import { lightRows } from './rows/light.ts';
import { puffRows } from './rows/puff.ts';
import { sceneRows, simulationRows } from './rows/simulation.ts';
import { smokeRows } from './rows/smoke.ts';
import { styleRows } from './rows/style.ts';

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

/** One group of the panel per possible list item. The panel shows it once the item is added. */
export const itemGroups: readonly { readonly key: string; readonly list: string; readonly label: string }[] =
  listNames.flatMap((list) =>
    Array.from({ length: LIST_LIMIT }, (_, index) => ({
      key: `${list}.${index}`,
      list,
      label: itemLabel(list, index),
    })),
  );

/** All parameters that the panel, links and attributes can set. */
export const table: readonly Parameter[] = [
  ...sceneRows,
  ...smokeRows,
  ...puffRows,
  ...styleRows,
  ...lightRows,
  ...cameraRows,
  ...airRows,
  ...simulationRows,
  ...listParameters(),
];

const rows: ReadonlyMap<string, Parameter> = new Map(table.map((parameter) => [parameter.key, parameter]));

/** The row with this key, or undefined. Safe for untrusted keys, `__proto__` included. */
export function findParameter(key: string): Parameter | undefined {
  return rows.get(key);
}
