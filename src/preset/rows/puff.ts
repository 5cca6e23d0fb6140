import type { NumberParameter, Parameter } from '../parameter.ts';
import { choice, quantity, simulated } from './row.ts';

/** Shape of the puffs. */
export const puffRows: readonly Parameter[] = [
  simulated('puff.variations', 'puff', {
    step: 1,
    slider: 'fine',
    label: 'Puff shapes',
    text: 'How many different shapes are mixed; a puff keeps the one it was born with.',
    isBaked: true,
  }),
  choice(
    'puff.form',
    'puff',
    'style',
    {
      label: 'Puffs',
      text: 'Lobes are true shapes from every side; billboards are pictures of puffs that turn to the viewer, as in the paper.',
      default: 'lobes',
    },
    [
      ['lobes', 'Lobes'],
      ['billboards', 'Billboards'],
    ],
  ),
  knob('lumpiness', 0.8, 'Lumpiness', 'How far lobes stand out of a puff: 0 is nearly a ball, 1 a bunch.'),
  knob('flatness', 0.2, 'Flatness', 'How much puffs are pressed flat.'),
  knob('roughness', 0.6, 'Roughness', 'How unequal and how unevenly spread the lobes of a puff are.'),
  quantity('puff.lobes', 'puff', 'style', {
    kind: 'integer',
    min: 5,
    max: 12,
    step: 1,
    default: 10,
    label: 'Lobes',
    text: 'How many lobes a puff has; more of them cost time.',
    isBaked: true,
  }),
  quantity('puff.seed', 'puff', 'style', {
    kind: 'integer',
    min: 0,
    max: 9999,
    step: 1,
    default: 0,
    label: 'Shapes from',
    text: 'Selects the puff shapes; 0 has shapes designed by hand.',
    isBaked: true,
  }),
];

/** A parameter of the lobe shape, 0 to 1. */
function knob(name: string, initial: number, label: string, text: string): NumberParameter {
  const range = { min: 0, max: 1, step: 0.01, default: initial, isBaked: true } as const;
  return quantity(`puff.${name}`, 'puff', 'style', { label, text, ...range });
}
