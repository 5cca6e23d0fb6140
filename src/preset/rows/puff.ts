import type { NumberParameter, Parameter } from '../parameter.ts';
import { choice, quantity, simulated } from './row.ts';

/** Shape of the puffs. */
export const puffRows: readonly Parameter[] = [
  simulated('puff.variations', 'puff', {
    step: 1,
    slider: 'fine',
    label: 'Puff shapes',
    text: 'Number of different shapes. A puff keeps its shape for life.',
    isBaked: true,
  }),
  simulated('puff.turn', 'puff', {
    step: 0.05,
    slider: 'even',
    label: 'Turn',
    text: 'How much puffs turn with the rotation of the air around them; 1 is as fast as the air. Billboards do not.',
  }),
  simulated('puff.stretch', 'puff', {
    step: 0.05,
    slider: 'even',
    unit: '\u00d7',
    label: 'Stretch',
    text: 'How long fast puffs get along their motion relative to the wind, at most; 1 keeps their shape. Billboards keep it too.',
  }),
  simulated('puff.billow', 'puff', {
    step: 0.05,
    slider: 'even',
    label: 'Billow',
    text: 'How much the lobes of a young puff are drawn together; they swell one after another as it grows. Billboards do not.',
  }),
  choice(
    'puff.form',
    'puff',
    'style',
    {
      label: 'Puffs',
      text: 'Lobes have a true shape from every side. Billboards are pictures of puffs that face the camera, as in the paper.',
      default: 'lobes',
    },
    [
      ['lobes', 'Lobes'],
      ['billboards', 'Billboards'],
    ],
  ),
  knob('lumpiness', 0.8, 'Lumpiness', 'How far lobes stand out of a puff: 0 is nearly a ball, 1 a bunch of balls.'),
  knob('flatness', 0.2, 'Flatness', 'How flat puffs are.'),
  knob('roughness', 0.6, 'Roughness', 'How much the size and the spacing of lobes vary.'),
  quantity('puff.lobes', 'puff', 'style', {
    kind: 'integer',
    min: 5,
    max: 12,
    step: 1,
    default: 10,
    label: 'Lobes',
    text: 'Number of lobes of a puff. More lobes take longer to draw.',
    isBaked: true,
  }),
  quantity('puff.seed', 'puff', 'style', {
    kind: 'integer',
    min: 0,
    max: 9999,
    step: 1,
    default: 0,
    label: 'Shape seed',
    text: 'Selects the puff shapes; 0 selects shapes designed by hand.',
    isBaked: true,
  }),
];

/** A parameter of the lobe shape, 0 to 1. */
function knob(name: string, initial: number, label: string, text: string): NumberParameter {
  const range = { min: 0, max: 1, step: 0.01, default: initial, isBaked: true } as const;
  return quantity(`puff.${name}`, 'puff', 'style', { label, text, ...range });
}
