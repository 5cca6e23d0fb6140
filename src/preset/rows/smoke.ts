import type { Parameter } from '../parameter.ts';
import { choiceOf, ofScene, simulated } from './row.ts';

/** Emission rate, lifetime and size of puffs. */
export const smokeRows: readonly Parameter[] = [
  simulated('emission.rate', 'emission', {
    step: 5,
    slider: 'fine',
    label: 'Rate',
    text: 'Number of new puffs per second.',
  }),
  simulated('emission.lifetime', 'emission', {
    step: 0.1,
    slider: 'fine',
    label: 'Lifetime',
    text: 'Lifetime of a puff.',
  }),
  simulated('emission.growthTime', 'emission', {
    step: 0.05,
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
  choiceOf(
    'emission.dissolve',
    'emission',
    {
      label: 'Dissolving',
      text: 'How puffs end as their density falls: they shrink, or holes open and leave crescents, rings and hooks. Billboards and the renderer selle have no holes.',
    },
    ['Shrink', 'Erode'],
  ),
  ofScene('emission.entrainment', 'emission', {
    slider: 'even',
    step: 0.01,
    label: 'Entrainment',
    text: 'How much puffs grow with the distance they travel through the air.',
  }),
  simulated('puff.size', 'emission', {
    step: 0.05,
    unit: '\u00d7',
    slider: 'fine',
    label: 'Puff size',
    text: 'Makes every puff larger or smaller.',
  }),
];
