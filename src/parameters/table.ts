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
import { choice, ofScene, quantity } from './rows/row.ts';

const TARGET = { min: -50, max: 50, unit: 'm' } as const;

/** Kind, position, colours and strength of the light. */
export const lightRows = [
  choice('light.kind', 'light', 'sun', ['sun', 'lamp']),
  quantity('light.azimuth', 'light', { min: -180, max: 180, default: 40, unit: '\u00b0' }),
  quantity('light.elevation', 'light', { min: 5, max: 90, default: 50, unit: '\u00b0' }),
  quantity('light.distance', 'light', { min: 0.5, max: 50, default: 4, unit: 'm' }),
  quantity('light.decay', 'light', { min: 0, max: 2, default: 0 }),
  { kind: 'color', key: 'light.color', reader: 'light', default: '#ffffff' },
  quantity('light.intensity', 'light', { min: 0, max: 4, default: 1 }),
  { kind: 'color', key: 'light.ambientColor', reader: 'light', default: '#ffffff' },
  quantity('light.ambient', 'light', { min: 0, max: 4, default: 1 }),
] as const satisfies readonly Parameter[];

/** Position and target of the camera. Without a value they follow the scene's camera and its animation. */
export const cameraRows = [
  ofScene(quantity('camera.azimuth', 'camera', { min: -180, max: 180, default: 8.6, unit: '\u00b0' })),
  ofScene(quantity('camera.elevation', 'camera', { min: -5, max: 88, default: 9.2, unit: '\u00b0' })),
  ofScene(quantity('camera.distance', 'camera', { min: 0.3, max: 40, default: 6.3, unit: 'm' })),
  ofScene(quantity('camera.target.x', 'camera', { ...TARGET, default: 0.15 })),
  ofScene(quantity('camera.target.y', 'camera', { ...TARGET, default: 1.5 })),
  ofScene(quantity('camera.target.z', 'camera', { ...TARGET, default: 0 })),
] as const satisfies readonly Parameter[];

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
