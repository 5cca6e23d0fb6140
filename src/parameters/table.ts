/**
 * The parameter table. The order of the rows is the order of keys in a link and of controls in the panel. New rows can
 * go anywhere, but a key is never renamed, because existing links would lose it. `words/table.ts` adds what the panel says.
 *
 * The defaults are those of the lamp scene (see presets.ts). Multipliers apply to the scene's value: 1 has no effect.
 */
import { listParameters } from './lists.ts';
import type { Parameter } from './parameter.ts';
import { airRows, puffRows, sceneRows, simulationRows, smokeRows } from './rows/smoke.ts';
import { styleRows } from './rows/style.ts';
import { cameraRows, lightRows } from './rows/view.ts';

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
