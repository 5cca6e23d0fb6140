import type { Parameter } from '../parameter.ts';
import { ofScene, quantity } from './row.ts';

/** Emission rate, lifetime and size of puffs. */
export const smokeRows: readonly Parameter[] = [
  quantity('emission.rate', 'emission', 'simulator', {
    min: 0,
    max: 20000,
    step: 5,
    default: 28,
    unit: 'particles/s',
    slider: 'fine',
    label: 'Rate',
    text: 'Number of new puffs per second.',
  }),
  quantity('emission.lifetime', 'emission', 'simulator', {
    min: 0.1,
    max: 60,
    step: 0.1,
    default: 7,
    unit: 's',
    slider: 'fine',
    label: 'Lifetime',
    text: 'Lifetime of a puff.',
  }),
  quantity('emission.growthTime', 'emission', 'simulator', {
    min: 0,
    max: 30,
    step: 0.05,
    default: 2.6,
    unit: 's',
    slider: 'fine',
    label: 'Growth time',
    text: 'Time in which a new puff grows to full size; 0 starts at full size, as in the paper.',
  }),
  {
    kind: 'curve',
    key: 'emission.density',
    group: 'emission',
    reader: 'simulator',
    label: 'Density',
    text: 'Size of a puff over its life, from birth to death; it always ends at 0.',
    default: '0:1,1:0',
  },
  ofScene('emission.entrainment', 'emission', {
    max: 1,
    default: 0,
    slider: 'even',
    step: 0.01,
    label: 'Entrainment',
    text: 'How much puffs grow with the distance they travel through the air.',
  }),
  quantity('puff.size', 'emission', 'simulator', {
    min: 0.1,
    max: 4,
    step: 0.05,
    default: 1,
    unit: '\u00d7',
    slider: 'fine',
    label: 'Puff size',
    text: 'Makes every puff larger or smaller.',
  }),
];
