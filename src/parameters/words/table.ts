/** The parameter table with what the panel and the documents say of each parameter. */
import type * as bare from '../parameter.ts';
import { table as rows, type cameraRows, type lightRows } from '../table.ts';
import { itemWords } from './lists.ts';
import { smokeWords } from './smoke.ts';
import { styleWords } from './style.ts';
import type { AnyWords, Parameter, WordsOf } from './words.ts';

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

/** What the panel says of light and camera. */
const viewWords: WordsOf<[...typeof lightRows, ...typeof cameraRows]> = {
  'light.kind': {
    label: 'Light',
    text: 'The sun is a directional light; a lamp is a point light, and shadows spread away from it.',
    options: { sun: 'Sun', lamp: 'Lamp' },
  },
  'light.azimuth': { label: 'Direction', text: 'Azimuth of the light: 0 is the front, 90 the right.', step: 1 },
  'light.elevation': { label: 'Height', text: 'Elevation of the light: 90 is straight above.', step: 1 },
  'light.distance': {
    label: 'Distance',
    text: 'Distance of a lamp from the centre of the scene; the sun ignores it.',
    step: 0.1,
    slider: 'fine',
  },
  'light.decay': {
    label: 'Decay',
    text: 'How fast the light of a lamp weakens with distance: 0 not at all, 2 as in nature. At the centre of the scene it keeps its strength.',
    step: 0.1,
  },
  'light.color': { label: 'Light colour', text: 'Colour of the light. White shows the tones of the style.' },
  'light.intensity': {
    label: 'Light strength',
    text: 'Strength of the light: 1 shows the tones of the style, 0 leaves their first one.',
    step: 0.05,
  },
  'light.ambientColor': {
    label: 'Ambient colour',
    text: 'Colour of the light that also reaches shadow. White shows the tones of the style.',
  },
  'light.ambient': {
    label: 'Ambient strength',
    text: 'Strength of the light that also reaches shadow; 1 shows the tones of the style.',
    step: 0.05,
  },
  'camera.azimuth': {
    label: 'Camera direction',
    text: 'Azimuth of the camera: 0 is the front, 90 the right.',
    step: 1,
  },
  'camera.elevation': { label: 'Camera elevation', text: 'Elevation of the camera: 0 is level.', step: 1 },
  'camera.distance': {
    label: 'Camera distance',
    text: 'Distance of the camera from its target.',
    step: 0.1,
    slider: 'fine',
  },
  'camera.target.x': {
    label: 'Camera target x',
    text: "Distance of the camera's target right of the scene's centre.",
    step: 0.05,
    slider: 'fine',
  },
  'camera.target.y': {
    label: 'Camera target y',
    text: "Distance of the camera's target above the ground.",
    step: 0.05,
    slider: 'fine',
  },
  'camera.target.z': {
    label: 'Camera target z',
    text: "Distance of the camera's target in front of the scene's centre.",
    step: 0.05,
    slider: 'fine',
  },
};

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
