import type { Parameter } from '../parameter.ts';
import { choice, quantity } from './row.ts';

/** Kind and position of the light. */
export const lightRows: readonly Parameter[] = [
  choice(
    'light.kind',
    'light',
    'light',
    {
      label: 'Light',
      text: 'The sun is a directional light; a lamp is a point light, and shadows spread away from it.',
      default: 'sun',
    },
    [
      ['sun', 'Sun'],
      ['lamp', 'Lamp'],
    ],
  ),
  quantity('light.azimuth', 'light', 'light', {
    min: -180,
    max: 180,
    step: 1,
    default: 40,
    unit: '\u00b0',
    label: 'Direction',
    text: 'Azimuth of the light: 0 is the front, 90 the right.',
  }),
  quantity('light.elevation', 'light', 'light', {
    min: 5,
    max: 90,
    step: 1,
    default: 50,
    unit: '\u00b0',
    label: 'Height',
    text: 'Elevation of the light: 90 is straight above.',
  }),
  quantity('light.distance', 'light', 'light', {
    min: 0.5,
    max: 50,
    step: 0.1,
    default: 4,
    unit: 'm',
    slider: 'fine',
    label: 'Distance',
    text: 'Distance of a lamp from the centre of the scene; the sun ignores it.',
  }),
];
